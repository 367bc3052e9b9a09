#include "SphericalPlacement.h"

#include "RandomOrientation.h"
#include "WorstCase.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::spherical_placement_test
{
namespace
{
using test::WorstCase;

// Symmetric with these semi-axes in a random frame.
Matrix3 RandomEllipsoid(std::mt19937_64& random, const Vector3& semiAxes)
{
  const Matrix3 frame = test::RandomOrientation(random);
  return frame * semiAxes.asDiagonal() * frame.transpose();
}

Matrix3 PolarRotation(const Matrix3& degreeOne)
{
  SphericalPlacement placement;
  const Status status = PlaceByPolarFactor(degreeOne, placement);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return placement.Rotation;
}

EllipsoidPlacement EllipsoidOf(const Matrix3& degreeOne)
{
  EllipsoidPlacement placement;
  const Status status = PlaceByEllipsoid(degreeOne, placement);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return placement;
}

TEST(SphericalPlacement, PolarFactorRecoversTheRotationOfAnEllipsoid)
{
  std::mt19937_64 random(1);
  WorstCase worst;
  for (int trial = 0; trial < 200; ++trial)
  {
    // Also with equal axes, where an ellipsoid's axes are arbitrary.
    const Vector3 semiAxes = trial % 3 == 0 ? Vector3(30.0, 30.0, 30.0) : Vector3(40.0, 30.0, 5.0);
    const Matrix3 turn = test::RandomOrientation(random);
    worst.Add((PolarRotation(RandomEllipsoid(random, semiAxes) * turn) - turn).norm());
  }
  EXPECT_LE(worst.Value(), 1e-13); // rounding times s1 / (s2 + s3)
}

TEST(SphericalPlacement, DeterminationHasTheSignOfTheShortestAxis)
{
  SphericalPlacement placement;
  ASSERT_TRUE(PlaceByPolarFactor(Vector3(40.0, 30.0, 10.0).asDiagonal(), placement).IsOk());
  EXPECT_NEAR(placement.Determination, 1.0, 1e-14);
  ASSERT_TRUE(PlaceByPolarFactor(Vector3(40.0, 30.0, -10.0).asDiagonal(), placement).IsOk());
  EXPECT_NEAR(placement.Determination, 0.5, 1e-14);
  EXPECT_NEAR((placement.Rotation - Matrix3::Identity()).norm(), 0.0, 1e-14);
}

TEST(SphericalPlacement, MirroredSurfacesGetMirroredPlacements)
{
  std::mt19937_64 random(2);
  const Matrix3 mirror = Vector3(-1.0, 1.0, 1.0).asDiagonal();
  WorstCase worst;
  for (int trial = 0; trial < 100; ++trial)
  {
    const Matrix3 degreeOne = RandomEllipsoid(random, {50.0, 20.0, trial % 2 == 0 ? 9.0 : -9.0}) *
                              test::RandomOrientation(random);
    worst.Add(
        (PolarRotation(mirror * degreeOne * mirror) - mirror * PolarRotation(degreeOne) * mirror)
            .norm());
  }
  EXPECT_LE(worst.Value(), 1e-13); // rounding
}

TEST(SphericalPlacement, NoiseTurnsThePolarFactorWithinItsBound)
{
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  for (int trial = 0; trial < 200; ++trial)
  {
    const Vector3 semiAxes(40.0, 38.0, 12.0);
    const Matrix3 degreeOne = RandomEllipsoid(random, semiAxes) * test::RandomOrientation(random);
    Matrix3 noise;
    for (Eigen::Index i = 0; i < 9; ++i)
    {
      noise(i) = 0.5 * normal(random);
    }
    const Matrix3 turn = PolarRotation(degreeOne + noise) * PolarRotation(degreeOne).transpose();
    const double angle = Eigen::AngleAxisd(turn).angle();
    // To first order the Frobenius norm over the sum of the two least; a tenth for the next order.
    EXPECT_LE(angle, 1.1 * std::sqrt(2.0) * noise.norm() / (semiAxes[1] + semiAxes[2]));
  }
}

TEST(SphericalPlacement, ScaleDoesNotMatter)
{
  std::mt19937_64 random(4);
  const Matrix3 degreeOne =
      RandomEllipsoid(random, {40.0, 30.0, 20.0}) * test::RandomOrientation(random);
  for (const double scale : {1e-200, 1e-3, 1e200})
  {
    EXPECT_NEAR((PolarRotation(scale * degreeOne) - PolarRotation(degreeOne)).norm(), 0.0, 1e-14);
  }
}

TEST(SphericalPlacement, EllipsoidReproducesTheSurfaceInItsFrame)
{
  std::mt19937_64 random(5);
  WorstCase worst;
  for (int trial = 0; trial < 100; ++trial)
  {
    const double last = trial % 2 == 0 ? 11.0 : -11.0;
    const Matrix3 degreeOne =
        RandomEllipsoid(random, {40.0, 25.0, last}) * test::RandomOrientation(random);
    const EllipsoidPlacement ellipsoid = EllipsoidOf(degreeOne);
    const Matrix3& rotation = ellipsoid.Placement.Rotation;
    EXPECT_NEAR(ellipsoid.Axes.determinant(), 1.0, 1e-14);
    EXPECT_NEAR(rotation.determinant(), 1.0, 1e-14);
    worst.Add((ellipsoid.SemiAxes - Vector3(40.0, 25.0, last)).norm());
    // v = Rotation u, so C u = Axes diag(SemiAxes) v.
    worst.Add((ellipsoid.Axes * ellipsoid.SemiAxes.asDiagonal() * rotation - degreeOne).norm());
  }
  EXPECT_LE(worst.Value(), 1e-12); // mm, rounding
}

TEST(SphericalPlacement, EllipsoidDoesNotDependOnHowTheMapLies)
{
  std::mt19937_64 random(6);
  const Matrix3 symmetric = RandomEllipsoid(random, {40.0, 25.0, 11.0});
  const Matrix3 axes = EllipsoidOf(symmetric).Axes;
  WorstCase worst;
  for (int trial = 0; trial < 50; ++trial)
  {
    worst.Add((EllipsoidOf(symmetric * test::RandomOrientation(random)).Axes - axes).norm());
  }
  EXPECT_LE(worst.Value(), 1e-12); // rounding over the relative difference of two axes
}

TEST(SphericalPlacement, SaysWhichAxesAreSimilar)
{
  const auto flags = [](double a, double b, double c)
  {
    const EllipsoidPlacement e = EllipsoidOf(Vector3(a, b, c).asDiagonal());
    return std::make_pair(e.IsLongestPairAmbiguous, e.IsShortestPairAmbiguous);
  };
  EXPECT_EQ(flags(40.0, 30.0, 20.0), std::make_pair(false, false));
  EXPECT_EQ(flags(40.0, 36.4, 20.0), std::make_pair(true, false));
  EXPECT_EQ(flags(40.0, 35.6, 20.0), std::make_pair(false, false));
  EXPECT_EQ(flags(40.0, 20.0, 19.0), std::make_pair(false, true));
  EXPECT_EQ(flags(40.0, 20.0, -19.0), std::make_pair(false, true));
  EXPECT_EQ(flags(1.0, 1.0, 1.0), std::make_pair(true, true));
}

TEST(SphericalPlacement, RejectsWhatDeterminesNoRotation)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinite = std::numeric_limits<double>::infinity();
  SphericalPlacement polar;
  EllipsoidPlacement ellipsoid;
  for (const Vector3& diagonal :
       {Vector3(0.0, 0.0, 0.0), Vector3(5.0, 0.0, 0.0), Vector3(5.0, 3.0, -3.0),
        Vector3(nan, 1.0, 1.0), Vector3(1.0, infinite, 1.0)})
  {
    const Matrix3 degreeOne = diagonal.asDiagonal();
    EXPECT_FALSE(PlaceByPolarFactor(degreeOne, polar).IsOk()) << diagonal.transpose();
    EXPECT_FALSE(PlaceByEllipsoid(degreeOne, ellipsoid).IsOk()) << diagonal.transpose();
  }
}
} // namespace
} // namespace palpate::spherical_placement_test
