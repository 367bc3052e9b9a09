#include "BallContact.h"
#include "ElasticCases.h"
#include "UnilateralSphere.h"

#include <gtest/gtest.h>

#include <limits>

namespace palpate::ball_contact_test
{
namespace
{
// c = 3 / (5 E* a)
PatchCompliance HalfSpace(double reducedModulus, double largest)
{
  PatchCompliance place{{}, largest};
  place.Coefficients[0] = 0.6 / reducedModulus;
  return place;
}

TEST(BallContact, IsHertzOnAHalfSpace)
{
  const double reduced = 0.026;
  const PatchCompliance place = HalfSpace(reduced, 9.0);
  for (const double curvature : {0.0, 0.04, -0.02})
  {
    const double effective = 1.0 / (1.0 / 8.0 + curvature);
    for (const double depth : {1e-6, 1e-3, 0.02})
    {
      const BallContact contact = BallContact::Of(depth, 8.0, curvature, place);
      const double force = 4.0 / 3.0 * reduced * std::sqrt(effective) * std::pow(depth, 1.5);
      // The next term of the gap is a^2/r^2 / 7 of the first.
      const double tolerance = 0.4 * depth / 8.0 + 1e-9;
      EXPECT_NEAR(contact.Force, force, tolerance * force) << depth << " " << curvature;
      EXPECT_NEAR(contact.PatchRadius, std::sqrt(effective * depth),
                  tolerance * contact.PatchRadius);
      EXPECT_NEAR(contact.Energy, 0.4 * force * depth, tolerance * contact.Energy);
      EXPECT_NEAR(contact.Slope, 1.5 * force / depth, tolerance * contact.Slope);
    }
  }
}

// The aims are 0.5 % and 2 % for a ball of 8 mm, 2.5 % for 4 mm down to 2 mm; 4 mm deep with a ball
// of 4 mm the patch is nearly as large as the ball.
TEST(BallContact, EqualsExactContactOfASphere)
{
  for (const double depthOfCore : {0.0, 5.0})
  {
    const test::ElasticCase& sphere = test::SphereCase(depthOfCore);
    const ComplianceSampler sampler(sphere.Model, sphere.Solid, sphere.Reduced);
    const PatchCompliance place = sampler.At(Vector3(0.3, 0.5, -0.8).normalized(), 9.0);
    const test::UnilateralSphere exact(test::SphereTruth(depthOfCore), 7.0, 100);
    for (const double ball : {8.0, 4.0})
    {
      for (const double depth : {0.25, 0.5, 1.0, 2.0, 3.0, 4.0})
      {
        const double wanted = exact.Force(ball, depth);
        const double found = BallContact::Of(depth, ball, 1.0 / test::Radius, place).Force;
        const double tolerance = depthOfCore > 0.0 ? 0.01 : 0.005;
        EXPECT_NEAR(found, wanted, tolerance * wanted)
            << ball << " mm, " << depth << " mm deep, core " << depthOfCore;
      }
    }
  }
}

TEST(UnilateralSphere, IsHertzForShallowContact)
{
  const test::UnilateralSphere sphere(test::SphereTruth(0.0), 1.0, 60);
  const double reduced = test::Tissue / (1.0 - test::Poisson * test::Poisson);
  const double effective = 1.0 / (1.0 / 8.0 + 1.0 / test::Radius);
  const double depth = 0.02;
  const double force = 4.0 / 3.0 * reduced * std::sqrt(effective) * std::pow(depth, 1.5);
  // The bed and the sphere behind the patch yield by a few parts of a/R.
  EXPECT_NEAR(sphere.Force(8.0, depth), force, 7.0 * std::sqrt(effective * depth) / 25.0 * force);
}

class RandomContact : public ::testing::Test
{
protected:
  // Between soft and hard below, as c of real places is.
  PatchCompliance Place()
  {
    std::uniform_real_distribution<double> part(-1.0, 1.0);
    PatchCompliance place{{25.0, -6.0, 0.0, 0.0, 0.0, 0.0, 0.0}, 9.0};
    double size = 2.0;
    for (std::size_t i = 1; i < PatchCompliance::Terms; ++i)
    {
      place.Coefficients[i] += size * part(this->Random);
      size *= 0.3;
    }
    return place;
  }
  double Uniform(double from, double to)
  {
    return std::uniform_real_distribution<double>(from, to)(this->Random);
  }

  std::mt19937_64 Random{17};
};

TEST_F(RandomContact, ForceIsTheSlopeOfTheEnergy)
{
  const double step = 1e-4;
  for (int i = 0; i < 300; ++i)
  {
    const PatchCompliance place = this->Place();
    const double ball = this->Uniform(2.0, 10.0);
    const double curvature = this->Uniform(-0.4 / ball, 0.1);
    const double depth = this->Uniform(0.01, 6.0);
    const auto at = [&](double d) { return BallContact::Of(d, ball, curvature, place); };
    const BallContact contact = at(depth);
    const double force = (at(depth + step).Energy - at(depth - step).Energy) / (2.0 * step);
    const double slope = (at(depth + step).Force - at(depth - step).Force) / (2.0 * step);
    EXPECT_NEAR(contact.Force, force, 1e-4 * force) << i;
    // A patch that becomes full between the two has a kink.
    EXPECT_NEAR(contact.Slope, slope,
                (at(depth + step).IsPatchFull == at(depth - step).IsPatchFull ? 1e-3 : 0.5) * slope)
        << i;
    const double bent = (BallContact::Of(depth, ball, curvature + step, place).Energy -
                         BallContact::Of(depth, ball, curvature - step, place).Energy) /
                        (2.0 * step);
    EXPECT_NEAR(contact.EnergyByCurvature(curvature), bent, 1e-3 * std::abs(bent)) << i;
  }
}

TEST_F(RandomContact, GrowsWithDepthWithoutJumps)
{
  for (int i = 0; i < 100; ++i)
  {
    const PatchCompliance place = this->Place();
    const double ball = this->Uniform(2.0, 10.0);
    double last = 0.0;
    double patch = 0.0;
    for (double depth = 0.01; depth < 12.0; depth += 0.01)
    {
      const BallContact contact = BallContact::Of(depth, ball, 0.04, place, patch);
      ASSERT_GT(contact.Force, last) << depth;
      ASSERT_LT(contact.Force - last, 0.02 * (contact.Slope + 1e-3)) << depth;
      last = contact.Force;
      patch = contact.PatchRadius;
    }
  }
}

TEST_F(RandomContact, DoesNotDependOnTheGuess)
{
  for (int i = 0; i < 200; ++i)
  {
    const PatchCompliance place = this->Place();
    const double depth = this->Uniform(0.001, 8.0);
    const BallContact contact = BallContact::Of(depth, 6.0, 0.02, place);
    for (const double start : {1e-3, 1.0, 8.9, 100.0})
    {
      const BallContact other = BallContact::Of(depth, 6.0, 0.02, place, start);
      EXPECT_NEAR(other.Force, contact.Force, 1e-9 * contact.Force) << i << " " << start;
    }
  }
}

// c = 10/a + a, which grows beyond the square root of 10.
TEST(BallContact, PatchStaysBelowOneThatYieldsMore)
{
  const PatchCompliance place{{10.0 + 30.375, 40.5, 10.125, 0.0, 0.0, 0.0, 0.0}, 9.0};
  ASSERT_NEAR(place.At(4.0).Compliance, 6.5, 1e-9);
  double last = 0.0;
  for (double depth = 0.1; depth < 30.0; depth *= 1.3)
  {
    const BallContact contact = BallContact::Of(depth, 8.0, 0.04, place);
    EXPECT_GT(contact.Force, last) << depth;
    EXPECT_LT(contact.Force, depth / place.At(3.0).Compliance) << depth;
    EXPECT_LT(contact.PatchRadius, std::sqrt(10.0)) << depth;
    EXPECT_FALSE(contact.IsPatchFull) << depth;
    last = contact.Force;
  }
}

TEST(BallContact, DoesNotTouchOutsideOrWhereItDoesNotFit)
{
  const PatchCompliance place = HalfSpace(0.026, 9.0);
  for (const double depth : {0.0, -1.0, std::numeric_limits<double>::quiet_NaN()})
  {
    EXPECT_EQ(BallContact::Of(depth, 8.0, 0.04, place).Force, 0.0);
  }
  EXPECT_EQ(BallContact::Of(1.0, 8.0, -0.2, place).Force, 0.0);
}
} // namespace
} // namespace palpate::ball_contact_test
