#include "RadiusRange.h"

#include "IcosahedronDirections.h"
#include "RadialSpectrum.h"
#include "RandomShapes.h"

#include <gtest/gtest.h>
#include <limits>

namespace palpate::radius_range_test
{
namespace
{
using test::Random;

// Allowed error of an evaluated radius, see RadialSpectrum.
double Rounding(const RadialModel& model)
{
  return 2.0 * RadialSpectrum(model).EvaluationError();
}

TEST(RadiusRange, EnclosesSamplesWithinTolerance)
{
  Random random(421);
  const IcosahedronDirections directions(20);
  for (const int degree : {2, 5, 12, 25})
  {
    const RadialModel model = test::RandomOrgan(random, degree);
    for (const double tolerance : {1.0, 1e-2, 1e-5})
    {
      const RadiusRange range = FindRadiusRange(model, tolerance);
      EXPECT_LE(range.LowestFound - range.Lower, tolerance);
      EXPECT_LE(range.Upper - range.HighestFound, tolerance);
      EXPECT_LE(range.Lower, range.LowestFound);
      EXPECT_LE(range.LowestFound, range.HighestFound);
      EXPECT_LE(range.HighestFound, range.Upper);
      for (const Vector3& u : directions.Directions())
      {
        EXPECT_GE(model.Radius(u), range.Lower);
        EXPECT_LE(model.Radius(u), range.Upper);
      }
    }
  }
}

TEST(RadiusRange, MatchesLinearFunction)
{
  Random random(422);
  for (int sample = 0; sample < 20; ++sample)
  {
    const std::vector<double> c = test::RandomCoefficients(random, 1);
    const RadialModel model(1, c, Vector3::Zero());
    const double mean = c[0] / std::sqrt(4 * M_PI);
    const double length = std::sqrt(3 / (4 * M_PI)) * Vector3(c[1], c[2], c[3]).norm();
    const RadiusRange range = FindRadiusRange(model, 1e-8);
    EXPECT_NEAR(range.Lower, mean - length, 1e-8); // the requested tolerance
    EXPECT_NEAR(range.Upper, mean + length, 1e-8);
    EXPECT_LE(range.Lower, mean - length + Rounding(model));
    EXPECT_GE(range.Upper, mean + length - Rounding(model));
  }
}

TEST(RadiusRange, FindsExtremesAtPolesAndEquator)
{
  // 3 z^2 - 1 from 2 at the poles to -1 on the whole equator.
  std::vector<double> c(9, 0.0);
  c[6] = std::sqrt(16 * M_PI / 5);
  const RadiusRange range = FindRadiusRange({2, c, Vector3::Zero()}, 1e-4);
  EXPECT_NEAR(range.Upper, 2.0, 1e-4); // the requested tolerance
  EXPECT_NEAR(range.Lower, -1.0, 1e-4);
  EXPECT_GE(range.Upper, 2.0 - 1e-11);
  EXPECT_LE(range.Lower, -1.0 + 1e-11);
}

TEST(RadiusRange, IsRadiusOfSphere)
{
  const double radius = 7.0;
  const RadiusRange range =
      FindRadiusRange({0, {radius * std::sqrt(4 * M_PI)}, Vector3::Zero()}, 0.0);
  // A tolerance of zero is replaced by the error of evaluation, 1e-12 relative.
  EXPECT_NEAR(range.Lower, radius, 1e-10);
  EXPECT_NEAR(range.Upper, radius, 1e-10);
  EXPECT_LE(range.Lower, radius);
  EXPECT_GE(range.Upper, radius);
}

TEST(RadiusRange, BoundsHoldIfToleranceIsUnreachable)
{
  // A ring of equal minima: a tolerance of 1e-10 would need millions of triangles.
  std::vector<double> c(9, 0.0);
  c[6] = std::sqrt(16 * M_PI / 5);
  const RadiusRange range = FindRadiusRange({2, c, Vector3::Zero()}, 1e-10);
  EXPECT_LE(range.Lower, -1.0 + 1e-11);
  EXPECT_GE(range.Lower, -1.0 - 1e-6); // the accuracy that half a million triangles reach
}

TEST(RadiusRange, IsNanForNonFiniteCoefficients)
{
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()})
  {
    const RadiusRange range = FindRadiusRange({1, {20.0, bad, 1.0, 1.0}, Vector3::Zero()}, 0.1);
    EXPECT_TRUE(std::isnan(range.Lower));
    EXPECT_TRUE(std::isnan(range.Upper));
  }
}

TEST(RadiusRange, ScalesWithModel)
{
  Random random(423);
  const std::vector<double> c = test::RandomCoefficients(random, 4);
  const RadiusRange plain = FindRadiusRange({4, c, Vector3::Zero()}, 1e-3);
  for (const int power : {-500, 500})
  {
    std::vector<double> scaled = c;
    for (double& value : scaled)
    {
      value = std::ldexp(value, power);
    }
    const RadiusRange range =
        FindRadiusRange({4, scaled, Vector3::Zero()}, std::ldexp(1e-3, power));
    // A power of two changes no digit, so the search takes the same steps.
    EXPECT_EQ(range.Lower, std::ldexp(plain.Lower, power));
    EXPECT_EQ(range.Upper, std::ldexp(plain.Upper, power));
  }
}
} // namespace
} // namespace palpate::radius_range_test
