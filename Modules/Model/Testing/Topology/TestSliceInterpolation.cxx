#include "SliceInterpolation.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::slice_interpolation_test
{
namespace
{
constexpr int Columns = 200; // of 0.5 mm
constexpr int Slices = 21;   // of 3 mm
constexpr double Pixel = 0.5;
constexpr double Thickness = 3.0;
constexpr double Bound = 0.75 * Thickness;
constexpr float Far = -std::numeric_limits<float>::infinity(); // slices without the object

using Wall = std::function<double(double)>; // mm, of a height

// Of a body behind a wall in the slices' plane, 20 mm deep; none in the slices from `end` on.
std::vector<float> DistancesTo(const Wall& wall, int end = Slices)
{
  std::vector<float> distances;
  for (int slice = 0; slice < Slices; ++slice)
  {
    for (int i = 0; i < Columns; ++i)
    {
      const double inside = wall(Thickness * slice) - Pixel * i;
      distances.push_back(slice < end ? static_cast<float>(std::min(inside, 20.0)) : Far);
    }
  }
  return distances;
}

// Columns at nodes along the slices' axis.
struct Sampled
{
  std::vector<float> Values;
  std::array<int, 3> Size{Columns, 1, Slices};

  float At(int node, int column) const
  {
    return this->Values[static_cast<std::size_t>(node * Columns + column)];
  }
  // Where the values of a node become negative, mm.
  double WallAt(int node) const
  {
    int column = 1;
    while (this->At(node, column) > 0.0F)
    {
      ++column;
    }
    const double inside = this->At(node, column - 1);
    return Pixel * (column - 1 + inside / (inside - this->At(node, column)));
  }
};

Sampled CurvedBetween(const std::vector<float>& distances, int perSlice)
{
  Sampled sampled;
  const AxisNodes nodes{Slices, perSlice * (Slices - 1) + 1, 0.0, 1.0 / perSlice, 0.0};
  sampled.Values = SliceInterpolation(distances, sampled.Size, 2, Bound).Between(nodes);
  sampled.Size[2] = nodes.Count;
  return sampled;
}

// A peak 1 mm high, 20 mm wide along a wall at 45 degrees, between the middle slices.
double BumpyWall(double z)
{
  const double along = std::sqrt(2.0) * (z - 10.5 * Thickness);
  const double cosine = std::abs(along) < 10.0 ? std::cos(M_PI * along / 20.0) : 0.0;
  return 10.0 + z + std::sqrt(2.0) * cosine * cosine;
}

TEST(SliceInterpolation, KeepsTheBumpOfAnObliqueWall)
{
  const Sampled sampled = CurvedBetween(DistancesTo(BumpyWall), 2);
  // 0.982 of it; bounded cubics have 0.960 there.
  const double height = sampled.WallAt(21) - 10.0 - 10.5 * Thickness;
  EXPECT_GT(height, 0.975 * std::sqrt(2.0));
  EXPECT_LT(height, std::sqrt(2.0));
}

TEST(SliceInterpolation, MeetsTheSlices)
{
  const Sampled sampled = CurvedBetween(DistancesTo(BumpyWall, 15), 4);
  for (int slice = 0; slice < 15; ++slice)
  {
    EXPECT_NEAR(sampled.WallAt(4 * slice), BumpyWall(Thickness * slice), 1e-4) << slice; // floats
  }
}

TEST(SliceInterpolation, EndsHalfWayToASliceWithoutTheObject)
{
  const int end = 15;
  const Sampled sampled = CurvedBetween(DistancesTo([](double) { return 60.0; }, end), 8);
  // 40 mm behind the wall.
  EXPECT_GT(sampled.At(8 * (end - 1) + 3, 40), 0.0F);
  EXPECT_LT(sampled.At(8 * (end - 1) + 5, 40), 0.0F);
}

TEST(SliceInterpolation, IsAsBoundedCubicsNextToAnEnd)
{
  const int end = 15;
  const std::vector<float> distances = DistancesTo(BumpyWall, end);
  const Sampled sampled = CurvedBetween(distances, 8);
  std::vector<float> bounded = distances;
  for (float& distance : bounded)
  {
    distance = std::clamp(distance, static_cast<float>(-Bound), static_cast<float>(Bound));
  }
  Sampled cubic;
  const AxisNodes nodes{Slices, 8 * (Slices - 1) + 1, 0.0, 0.125, 0.0};
  cubic.Values =
      AxisWeights(nodes, AxisWeights::Interpolation::Cubic).Apply(bounded, cubic.Size, 2);
  for (int node = 8 * (end - 3); node < sampled.Size[2]; ++node)
  {
    // Far outside, slices without the object are no farther from the wall.
    for (int column = 0; Pixel * column < BumpyWall(Thickness * end) + 10.0; ++column)
    {
      ASSERT_EQ(sampled.At(node, column), cubic.At(node, column)) << node;
    }
  }
}

// The largest difference between neighbouring nodes.
double LargestStep(const Sampled& sampled)
{
  double step = 0.0;
  for (int node = 0; node + 1 < sampled.Size[2]; ++node)
  {
    for (int column = 0; column < Columns; ++column)
    {
      step =
          std::max<double>(step, std::abs(sampled.At(node + 1, column) - sampled.At(node, column)));
    }
  }
  return step;
}

TEST(SliceInterpolation, IsContinuous)
{
  std::mt19937_64 random(9700);
  std::normal_distribution<double> normal(0.0, 1.2); // second differences about the bound
  for (int body = 0; body < 20; ++body)
  {
    std::vector<double> walls(Slices);
    std::generate(walls.begin(), walls.end(), [&] { return 50.0 + normal(random); });
    const auto wall = [&](double z)
    { return walls[static_cast<std::size_t>(z / Thickness + 0.5)]; };
    const std::vector<float> distances = DistancesTo(wall, 16);
    // Half as far apart, half as different; steps stay.
    const double ratio =
        LargestStep(CurvedBetween(distances, 64)) / LargestStep(CurvedBetween(distances, 32));
    EXPECT_LT(ratio, 0.52) << body;
  }
}

TEST(SliceInterpolation, DoesNotBulgeNextToALedge)
{
  constexpr double Least = 40.0;
  for (const double height : {3.0, 8.0, 20.0, 40.0})
  {
    const auto ledge = [&](double z) { return z < 10.0 * Thickness ? Least + height : Least; };
    const Sampled sampled = CurvedBetween(DistancesTo(ledge), 8);
    for (int node = 8; node < sampled.Size[2] - 8; ++node)
    {
      // A tenth of twice the bound.
      EXPECT_GT(sampled.WallAt(node), Least - 0.2 * Bound) << height << " at " << node;
      EXPECT_LT(sampled.WallAt(node), Least + height + 0.2 * Bound) << height << " at " << node;
    }
  }
}

TEST(SliceInterpolation, DoesNotDependOnTheSlicesAxis)
{
  const std::vector<float> distances = DistancesTo(BumpyWall, 15);
  const Sampled sampled = CurvedBetween(distances, 4);
  const AxisNodes nodes{Slices, 4 * (Slices - 1) + 1, 0.0, 0.25, 0.0};
  // Columns along i and slices across j; the same twice, along k.
  std::vector<float> twice = distances;
  twice.insert(twice.end(), distances.begin(), distances.end());
  std::vector<float> expected = sampled.Values;
  expected.insert(expected.end(), sampled.Values.begin(), sampled.Values.end());
  EXPECT_EQ(SliceInterpolation(twice, {Columns, Slices, 2}, 1, Bound).Between(nodes), expected);

  std::vector<float> turned(distances.size());
  for (std::size_t at = 0; at < distances.size(); ++at)
  {
    turned[at % Columns * Slices + at / Columns] = distances[at];
  }
  const std::vector<float> values =
      SliceInterpolation(turned, {Slices, 1, Columns}, 0, Bound).Between(nodes);
  ASSERT_EQ(values.size(), sampled.Values.size());
  for (int node = 0; node < nodes.Count; ++node)
  {
    for (int column = 0; column < Columns; ++column)
    {
      const auto at = static_cast<std::size_t>(column * nodes.Count + node);
      ASSERT_NEAR(values[at], sampled.At(node, column), 1e-5) << node; // order of sums
    }
  }
}

TEST(SliceInterpolation, ResamplesSlicesFirst)
{
  // Every other column.
  const std::vector<float> distances = DistancesTo(BumpyWall, 15);
  const Sampled sampled = CurvedBetween(distances, 4);
  SliceInterpolation slices(distances, {Columns, 1, Slices}, 2, Bound);
  slices.Resample(AxisWeights({Columns, Columns / 2, 0.0, 2.0, 0.0}), 0);
  const std::vector<float> values = slices.Between({Slices, 4 * (Slices - 1) + 1, 0.0, 0.25, 0.0});
  ASSERT_EQ(values.size(), sampled.Values.size() / 2);
  for (std::size_t at = 0; at < values.size(); ++at)
  {
    ASSERT_EQ(values[at], sampled.Values[2 * at]) << at;
  }
}
} // namespace
} // namespace palpate::slice_interpolation_test
