#include "IcosahedronDirections.h"
#include "RandomShapes.h"
#include "SurfaceCorrection.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::surface_correction_test
{
namespace
{
using namespace palpate::test;

constexpr double Radius = 25.0;

SurfaceCorrection Sphere(int frequency = 10)
{
  const std::vector<Vector3> directions = IcosahedronDirections(frequency).Directions();
  std::vector<Vector3> points;
  for (const Vector3& direction : directions)
  {
    points.emplace_back(Radius * direction);
  }
  return {points, directions, SurfaceCorrection::Motion::Free};
}

SurfacePull PullAt(const Vector3& place, double by, double width, double second = 0.0)
{
  return {place, by, {}, width, second};
}

Vector3 At(const SurfaceCorrection& correction, const Vector3& direction)
{
  return correction.DisplacementAt(Radius * direction, direction);
}

TEST(SurfaceCorrection, OnePullIsItsKernel)
{
  SurfaceCorrection correction = Sphere();
  const Vector3 place = correction.Points()[17];
  const Vector3 way = correction.Directions()[17];
  ASSERT_TRUE(correction.Pull(PullAt(place, 4.0, 6.0)).IsOk());
  for (std::size_t n = 0; n < correction.Points().size(); ++n)
  {
    const double square = (correction.Points()[n] - place).squaredNorm();
    const Vector3 wanted =
        4.0 * std::exp(-square / 72.0) * 0.5 * (1.0 + way.dot(correction.Directions()[n])) * way;
    // Beyond 4.5 widths the kernel ends.
    EXPECT_LT((correction.Displacements().col(static_cast<Eigen::Index>(n)) - wanted).norm(), 2e-4);
  }
}

TEST(SurfaceCorrection, TwoWidthsAreTheirMean)
{
  SurfaceCorrection one = Sphere();
  SurfaceCorrection other = Sphere();
  SurfaceCorrection sum = Sphere();
  const Vector3 place = sum.Points()[3];
  ASSERT_TRUE(one.Pull(PullAt(place, 4.0, 5.0)).IsOk());
  ASSERT_TRUE(other.Pull(PullAt(place, 4.0, 11.0)).IsOk());
  ASSERT_TRUE(sum.Pull(PullAt(place, 4.0, 5.0, 11.0)).IsOk());
  const Eigen::Matrix3Xd mean = 0.5 * (one.Displacements() + other.Displacements());
  EXPECT_LT((sum.Displacements() - mean).cwiseAbs().maxCoeff(), 2e-4); // the ends of the kernels
}

TEST(SurfaceCorrection, PlacesOfFormerPullsStay)
{
  Random random(1);
  std::uniform_real_distribution<double> number(-6.0, 6.0);
  SurfaceCorrection correction = Sphere();
  // The places are 13 mm apart or more, half of the largest width or farther.
  const std::vector<Vector3> places = IcosahedronDirections(2).Directions();
  for (std::size_t n = 0; n < places.size(); ++n)
  {
    std::vector<Vector3> before;
    for (const Vector3& place : places)
    {
      before.push_back(At(correction, place));
    }
    const double by = number(random);
    const double second = n % 2 == 0 ? 0.0 : 4.0;
    ASSERT_TRUE(
        correction.Pull(PullAt(Radius * places[n] + before[n], by, 6.0 + std::abs(by), second))
            .IsOk());
    for (std::size_t former = 0; former < n; ++former)
    {
      // Kernels end, and end in steps: 4e-5 of each weight.
      EXPECT_LT((At(correction, places[former]) - before[former]).norm(), 5e-3);
    }
    EXPECT_LT((At(correction, places[n]) - before[n] - by * places[n]).norm(), 1e-4);
  }
}

TEST(SurfaceCorrection, ATargetIsReached)
{
  SurfaceCorrection correction = Sphere();
  ASSERT_TRUE(correction.Pull(PullAt(Vector3(Radius, 3.0, 0.0), 2.0, 9.0)).IsOk());
  SurfacePull pull;
  pull.PlaceWorld = correction.PointNow(40);
  pull.TargetWorld = correction.PointNow(40) + Vector3(1.0, -2.0, 3.0);
  ASSERT_TRUE(correction.Pull(pull).IsOk());
  EXPECT_LT((correction.PointNow(40) - *pull.TargetWorld).norm(), 1e-4);
}

TEST(SurfaceCorrection, APlaceIsPulledAgain)
{
  SurfaceCorrection correction = Sphere();
  for (int n = 1; n <= 3; ++n)
  {
    ASSERT_TRUE(correction.Pull(PullAt(correction.PointNow(5), 2.0, 8.0)).IsOk());
    EXPECT_NEAR(correction.Displacements().col(5).norm(), 2.0 * n, 1e-4);
  }
  // Nothing overshoots next to it.
  EXPECT_NEAR(correction.Displacements().colwise().norm().maxCoeff(), 6.0, 1e-4);
}

TEST(SurfaceCorrection, PointsMayKeepToTheirDirections)
{
  const SurfaceCorrection sphere = Sphere();
  SurfaceCorrection correction(sphere.Points(), sphere.Directions(),
                               SurfaceCorrection::Motion::AlongDirections);
  SurfacePull pull = PullAt(correction.Points()[7], 0.0, 9.0);
  pull.TargetWorld = Vector3(correction.Points()[7] * 1.2 + Vector3(1.0, 1.0, 1.0));
  ASSERT_TRUE(correction.Pull(pull).IsOk());
  for (Eigen::Index n = 0; n < correction.Displacements().cols(); ++n)
  {
    const Vector3 way = correction.Directions()[static_cast<std::size_t>(n)];
    EXPECT_LT(correction.Displacements().col(n).cross(way).norm(), 1e-9); // rounding
  }
  const Vector3 way = correction.Directions()[7];
  EXPECT_NEAR(correction.PointNow(7).dot(way), pull.TargetWorld->dot(way), 1e-4);
}

TEST(SurfaceCorrection, UndoneBitForBit)
{
  Random random(2);
  std::uniform_real_distribution<double> number(-1.0, 1.0);
  SurfaceCorrection correction = Sphere(6);
  std::vector<Eigen::Matrix3Xd> states{correction.Displacements()};
  for (int n = 0; n < 12; ++n)
  {
    const Vector3 place(number(random), number(random), number(random));
    ASSERT_TRUE(correction.Pull(PullAt(Radius * place, 5.0 * place[0], 7.0, n % 3 * 4.0)).IsOk());
    states.push_back(correction.Displacements());
  }
  for (std::size_t n = states.size() - 1; n > 0; --n)
  {
    ASSERT_EQ(correction.Displacements(), states[n]);
    correction.Undo();
  }
  EXPECT_EQ(correction.Displacements(), states[0]);
  correction.Undo();
  EXPECT_TRUE(correction.Pulls().empty());
}

TEST(SurfaceCorrection, APreviewIsThePull)
{
  SurfaceCorrection correction = Sphere();
  ASSERT_TRUE(correction.Pull(PullAt(correction.Points()[1], 3.0, 6.0)).IsOk());
  const SurfacePull pull = PullAt(correction.Points()[9], -2.0, 10.0);
  const Eigen::Matrix3Xd before = correction.Displacements();
  Eigen::Matrix3Xd shown;
  ASSERT_TRUE(correction.Preview(pull, shown).IsOk());
  EXPECT_EQ(correction.Displacements(), before);
  ASSERT_TRUE(correction.Pull(pull).IsOk());
  EXPECT_EQ(correction.Displacements(), shown);
}

TEST(SurfaceCorrection, TheOtherWallOfASheetStays)
{
  std::vector<Vector3> points;
  std::vector<Vector3> directions;
  for (int n = 0; n < 200; ++n)
  {
    const bool isAbove = n % 2 == 0;
    points.emplace_back(n / 2 % 10, n / 20, isAbove ? 1.0 : -1.0);
    directions.emplace_back(0.0, 0.0, isAbove ? 1.0 : -1.0);
  }
  SurfaceCorrection correction(points, directions, SurfaceCorrection::Motion::Free);
  ASSERT_TRUE(correction.Pull(PullAt(Vector3(4.0, 4.0, 1.2), 3.0, 8.0)).IsOk());
  for (int n = 1; n < 200; n += 2)
  {
    EXPECT_TRUE(correction.Displacements().col(n).isZero(0.0));
  }
  EXPECT_NEAR(correction.Displacements().row(2).maxCoeff(), 3.0, 1e-4);
}

TEST(SurfaceCorrection, RefusesWithoutAnEffect)
{
  SurfaceCorrection correction = Sphere(4);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SurfacePull aimless = PullAt(Vector3::UnitX(), 1.0, 8.0);
  aimless.TargetWorld = Vector3(nan, 0.0, 0.0);
  for (const SurfacePull& pull :
       {PullAt(Vector3(nan, 0.0, 0.0), 1.0, 8.0), PullAt(Vector3::UnitX(), nan, 8.0),
        PullAt(Vector3::UnitX(), 1.0, nan), PullAt(Vector3::UnitX(), 201.0, 8.0),
        PullAt(Vector3::UnitX(), 1.0, 0.4), PullAt(Vector3::UnitX(), 1.0, 8.0, -1.0), aimless})
  {
    EXPECT_FALSE(correction.Pull(pull).IsOk());
  }
  EXPECT_TRUE(correction.Displacements().isZero(0.0));
  EXPECT_FALSE(SurfaceCorrection().Pull(PullAt(Vector3::UnitX(), 1.0, 8.0)).IsOk());
}

TEST(SurfaceCorrection, PullsAreBounded)
{
  SurfaceCorrection correction = Sphere(1);
  for (std::size_t n = 0; n < SurfaceCorrection::MostPulls; ++n)
  {
    ASSERT_TRUE(correction.Pull(PullAt(correction.PointNow(n % 12), 0.01, 5.0)).IsOk());
  }
  EXPECT_FALSE(correction.Pull(PullAt(Vector3::UnitX(), 1.0, 5.0)).IsOk());
}
} // namespace
} // namespace palpate::surface_correction_test
