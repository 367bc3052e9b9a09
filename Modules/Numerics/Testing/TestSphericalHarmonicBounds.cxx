#include "SphericalHarmonicBounds.h"

#include "IcosahedronDirections.h"
#include "RandomShapes.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::spherical_harmonic_bounds_test
{
namespace
{
using test::Random;
using Sample = SphericalHarmonicModel::Sample;

SphericalHarmonicBounds MakeBounds(const SphericalHarmonicModel& model, int depth, int refinement)
{
  SphericalHarmonicBounds::Options options;
  options.Depth = depth;
  options.Refinement = refinement;
  return {model, options};
}

// A direction in the cone, often on its boundary.
Vector3 RandomInCone(Random& random, const Vector3& axis, double halfAngle)
{
  std::uniform_real_distribution<double> part(0.0, 1.5);
  const double angle = halfAngle * std::min(1.0, part(random));
  const Vector3 tangent = axis.cross(test::RandomDirection(random)).normalized();
  return (std::cos(angle) * axis + std::sin(angle) * tangent).normalized();
}

// Slow reference: the range of radius and slope over a cone, sampled along many directions, which
// is too narrow.
struct Seen
{
  RadiusInterval Radius{std::numeric_limits<double>::infinity(),
                        -std::numeric_limits<double>::infinity()};
  double Slope = 0.0;

  Seen(const SphericalHarmonicModel& model, const Vector3& axis, double halfAngle, Random& random,
       int count)
  {
    for (int k = 0; k < count; ++k)
    {
      const Sample sample = model.Evaluate(RandomInCone(random, axis, halfAngle));
      this->Radius.Lower = std::min(this->Radius.Lower, sample.Radius);
      this->Radius.Upper = std::max(this->Radius.Upper, sample.Radius);
      this->Slope = std::max(this->Slope, sample.SurfaceGradient.norm());
    }
  }
};

const std::vector<double> Angles = {0.0, 1e-9, 1e-3, 0.05, 0.2, 0.6, 1.5, 2.5, M_PI};

TEST(SphericalHarmonicBounds, EncloseRadiiAndSlopesInCone)
{
  Random random(431);
  for (const int degree : {0, 1, 4, 12, 30})
  {
    const SphericalHarmonicModel model = test::RandomOrgan(random, degree);
    for (const int depth : {0, 1, 3})
    {
      const SphericalHarmonicBounds bounds = MakeBounds(model, depth, 1);
      std::vector<Vector3> axes = test::RandomDirections(random, 10);
      axes.insert(axes.end(), {{0, 0, 1}, {0, 0, -1}, {1, 0, 0}});
      for (const Vector3& axis : axes)
      {
        for (const double angle : Angles)
        {
          const Seen seen(model, axis, angle, random, 30);
          const RadiusInterval radius = bounds.RadiusInCone(axis, angle);
          EXPECT_LE(radius.Lower, seen.Radius.Lower) << degree << ' ' << depth << ' ' << angle;
          EXPECT_GE(radius.Upper, seen.Radius.Upper) << degree << ' ' << depth << ' ' << angle;
          EXPECT_GE(bounds.SlopeInCone(axis, angle), seen.Slope)
              << degree << ' ' << depth << ' ' << angle;
        }
      }
    }
  }
}

TEST(SphericalHarmonicBounds, EncloseConesAtCornersAndEdges)
{
  Random random(432);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
  const SphericalHarmonicBounds bounds(model);
  const IcosahedronDirections axes(8);
  for (const Vector3& axis : axes.Directions())
  {
    const double angle = 0.07;
    const Seen seen(model, axis, angle, random, 20);
    const RadiusInterval radius = bounds.RadiusInCone(axis, angle);
    EXPECT_LE(radius.Lower, seen.Radius.Lower);
    EXPECT_GE(radius.Upper, seen.Radius.Upper);
  }
}

TEST(SphericalHarmonicBounds, AreTightToSmallestTriangle)
{
  Random random(433);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
  const SphericalHarmonicBounds bounds(model);
  const IcosahedronDirections directions(40); // no direction is further than 0.02 rad from one
  // Default options: caps reach 37 / 8 degrees and up to a fifth more, so a triangle at the
  // boundary reaches twice that beyond it; parts of triangles are a quarter of the size.
  const double reach = 0.2;
  const double part = 0.025;
  const double bend = bounds.Spectrum().SecondDerivative();
  for (const Vector3& axis : test::RandomDirections(random, 30))
  {
    for (const double angle : {0.1, 0.3, 0.5, 0.8, 1.2})
    {
      RadiusInterval seen{1e9, 0.0};
      double slope = 0.0;
      for (const Vector3& u : directions.Directions())
      {
        if (u.dot(axis) >= std::cos(angle + reach))
        {
          const Sample sample = model.Evaluate(u);
          seen.Lower = std::min(seen.Lower, sample.Radius);
          seen.Upper = std::max(seen.Upper, sample.Radius);
          slope = std::max(slope, sample.SurfaceGradient.norm());
        }
      }
      // Taylor's formula over a part, including slopes between the directions.
      const double slack = slope * part + 1.5 * bend * part * part;
      const RadiusInterval radius = bounds.RadiusInCone(axis, angle);
      EXPECT_GE(radius.Lower, seen.Lower - slack) << angle;
      EXPECT_LE(radius.Upper, seen.Upper + slack) << angle;
      EXPECT_LE(bounds.SlopeInCone(axis, angle), slope + 2 * bend * part) << angle;
    }
  }
}

TEST(SphericalHarmonicBounds, NarrowConeHasBoundsOfAxis)
{
  Random random(434);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
  const SphericalHarmonicBounds bounds(model);
  for (const Vector3& axis : test::RandomDirections(random, 20))
  {
    const RadiusInterval radius = bounds.RadiusInCone(axis, 0.0);
    // The margin for rounded geometry, 1e-6 rad, times slopes of up to 20 mm/rad, on both sides.
    EXPECT_LE(radius.Upper - radius.Lower, 4e-5);
  }
}

TEST(SphericalHarmonicBounds, DepthAndRefinementTightenBounds)
{
  Random random(435);
  const SphericalHarmonicModel model = test::RandomOrgan(random, 12);
  double width = std::numeric_limits<double>::infinity();
  double slope = std::numeric_limits<double>::infinity();
  for (const int level : {0, 1, 2})
  {
    const SphericalHarmonicBounds bounds = MakeBounds(model, level, level);
    EXPECT_LT(bounds.Radius().Upper - bounds.Radius().Lower, width);
    EXPECT_LE(bounds.Slope(), slope);
    width = bounds.Radius().Upper - bounds.Radius().Lower;
    slope = bounds.Slope();
  }
}

TEST(SphericalHarmonicBounds, HalfAnglePiIsWholeSphere)
{
  Random random(436);
  const SphericalHarmonicBounds bounds(test::RandomOrgan(random, 9));
  const Vector3 axis = test::RandomDirection(random);
  for (const double angle : {M_PI, 4.0, std::numeric_limits<double>::infinity(), std::nan("")})
  {
    const RadiusInterval radius = bounds.RadiusInCone(axis, angle);
    EXPECT_EQ(radius.Lower, bounds.Radius().Lower);
    EXPECT_EQ(radius.Upper, bounds.Radius().Upper);
    EXPECT_EQ(bounds.SlopeInCone(axis, angle), bounds.Slope());
  }
}

TEST(SphericalHarmonicBounds, NegativeHalfAngleIsAxis)
{
  Random random(437);
  const SphericalHarmonicBounds bounds(test::RandomOrgan(random, 9));
  const Vector3 axis = test::RandomDirection(random);
  EXPECT_EQ(bounds.RadiusInCone(axis, -1.0).Lower, bounds.RadiusInCone(axis, 0.0).Lower);
  EXPECT_EQ(bounds.SlopeInCone(axis, -1.0), bounds.SlopeInCone(axis, 0.0));
}

TEST(SphericalHarmonicBounds, InvalidAxisIsWholeSphere)
{
  Random random(438);
  const SphericalHarmonicBounds bounds(test::RandomOrgan(random, 5));
  for (const double angle : {0.0, 0.5})
  {
    const RadiusInterval radius = bounds.RadiusInCone({std::nan(""), 0.0, 1.0}, angle);
    EXPECT_EQ(radius.Lower, bounds.Radius().Lower);
    EXPECT_EQ(radius.Upper, bounds.Radius().Upper);
    EXPECT_EQ(bounds.SlopeInCone({0.0, std::nan(""), 1.0}, angle), bounds.Slope());
  }
}

TEST(SphericalHarmonicBounds, AreNanForNonFiniteCoefficients)
{
  const SphericalHarmonicModel model(1, {20.0, std::nan(""), 1.0, 1.0}, Vector3::Zero());
  const SphericalHarmonicBounds bounds = MakeBounds(model, 1, 0);
  EXPECT_TRUE(std::isnan(bounds.Radius().Lower));
  EXPECT_TRUE(std::isnan(bounds.Slope()));
  for (const double angle : {0.0, 0.5, 3.0})
  {
    const RadiusInterval radius = bounds.RadiusInCone({0, 0, 1}, angle);
    EXPECT_TRUE(std::isnan(radius.Lower));
    EXPECT_TRUE(std::isnan(radius.Upper));
    EXPECT_TRUE(std::isnan(bounds.SlopeInCone({0, 0, 1}, angle)));
  }
}

TEST(SphericalHarmonicBounds, SphereHasItsRadiusAndNoSlope)
{
  const SphericalHarmonicBounds bounds({0, {5.0 * std::sqrt(4 * M_PI)}, Vector3::Zero()});
  const RadiusInterval radius = bounds.RadiusInCone({0, 1, 0}, 0.4);
  EXPECT_NEAR(radius.Lower, 5.0, 1e-10); // evaluation is accurate to 1e-12 of the radius
  EXPECT_NEAR(radius.Upper, 5.0, 1e-10);
  EXPECT_EQ(bounds.SlopeInCone({0, 1, 0}, 0.4), 0.0);
}
} // namespace
} // namespace palpate::spherical_harmonic_bounds_test
