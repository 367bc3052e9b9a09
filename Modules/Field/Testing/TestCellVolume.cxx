#include "CellVolume.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::cell_volume_test
{
namespace
{
using Corners = std::array<double, 8>;

double ValueAt(const Corners& c, double u, double v, double w)
{
  const auto mean = [](double a, double b, double t) { return a * (1.0 - t) + b * t; };
  const double low = mean(mean(c[0], c[1], u), mean(c[2], c[3], u), v);
  const double high = mean(mean(c[4], c[5], u), mean(c[6], c[7], u), v);
  return mean(low, high, w);
}

// Brute force: a fine lattice of points.
double PartByCounting(const Corners& corners)
{
  constexpr int Points = 60;
  int inside = 0;
  for (int i = 0; i < Points; ++i)
  {
    for (int j = 0; j < Points; ++j)
    {
      for (int k = 0; k < Points; ++k)
      {
        inside += ValueAt(corners, (i + 0.5) / Points, (j + 0.5) / Points, (k + 0.5) / Points) >= 0;
      }
    }
  }
  return inside / std::pow(Points, 3);
}

TEST(CellVolume, CellsWithoutSurfaceAreFullOrEmpty)
{
  EXPECT_EQ(InsidePartOfCell({{0, 1, 2, 3, 4, 5, 6, 7}}), 1.0);
  EXPECT_EQ(InsidePartOfCell({{-0.5, -1, -2, -3, -4, -5, -6, -7}}), 0.0);
}

TEST(CellVolume, CountsWhereBothValuesAreNonNegative)
{
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  for (int trial = 0; trial < 60; ++trial)
  {
    CellCorners two[2];
    for (std::size_t n = 0; n < 8; ++n)
    {
      two[0][n] = value(random) + 0.3;
      two[1][n] = value(random) + 0.3;
    }
    constexpr int Points = 40;
    int inside = 0;
    for (int n = 0; n < Points * Points * Points; ++n)
    {
      const double u = (n % Points + 0.5) / Points;
      const double v = (n / Points % Points + 0.5) / Points;
      const double w = (n / Points / Points + 0.5) / Points;
      inside += ValueAt(two[0], u, v, w) >= 0 && ValueAt(two[1], u, v, w) >= 0;
    }
    // As a single surface with strong curvature, and creases where two meet.
    EXPECT_NEAR(InsidePartOfCell(two, 2), inside / std::pow(Points, 3), 0.05);
    EXPECT_LE(InsidePartOfCell(two, 2), InsidePartOfCell(two[0]));
    EXPECT_EQ(InsidePartOfCell(two, 1), InsidePartOfCell(two[0]));
  }
}

TEST(CellVolume, SlabsAlongEveryAxisAreExact)
{
  for (int axis = 0; axis < 3; ++axis)
  {
    Corners corners{};
    for (std::size_t n = 0; n < 8; ++n)
    {
      corners[n] = (n >> axis & 1) == 0 ? -0.25 : 0.75;
    }
    // Along i and j, Gauss' rule integrates a step, with an error of up to one weight.
    EXPECT_NEAR(InsidePartOfCell(corners), 0.75, axis == 2 ? 1e-15 : 0.08) << axis;
  }
}

TEST(CellVolume, BothSidesSumToTheCell)
{
  std::mt19937_64 random(1);
  std::normal_distribution<double> value;
  for (int trial = 0; trial < 1000; ++trial)
  {
    Corners corners{};
    Corners opposite{};
    for (std::size_t n = 0; n < 8; ++n)
    {
      corners[n] = value(random);
      opposite[n] = -corners[n];
    }
    EXPECT_NEAR(InsidePartOfCell(corners) + InsidePartOfCell(opposite), 1.0, 1e-14);
  }
}

TEST(CellVolume, RandomCellsAgreeWithPointCounts)
{
  std::mt19937_64 random(2);
  std::normal_distribution<double> value;
  double sum = 0.0;
  constexpr int Trials = 200;
  for (int trial = 0; trial < Trials; ++trial)
  {
    Corners corners{};
    for (double& corner : corners)
    {
      corner = value(random);
    }
    const double error = InsidePartOfCell(corners) - PartByCounting(corners);
    EXPECT_NEAR(error, 0.0, 0.08) << trial; // kinks between Gauss' points: up to a weight
    sum += error;
  }
  // Errors are unbiased: their mean is at most a tenth of a single one.
  EXPECT_NEAR(sum / Trials, 0.0, 0.002);
}
} // namespace
} // namespace palpate::cell_volume_test
