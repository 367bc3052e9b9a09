#include "VelocityEstimate.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::velocity_estimate_test
{
namespace
{
constexpr double Period = 0.001; // s

TEST(VelocityEstimate, UnfilteredDifferencesAreExactForSteadyMotion)
{
  VelocityEstimate estimate(0.0);
  const Vector3 velocity(30.0, -20.0, 5.0);
  EXPECT_EQ(estimate.Update(Vector3::Ones(), Period), Vector3::Zero());
  for (int n = 1; n < 10; ++n)
  {
    const Vector3 v = estimate.Update(Vector3::Ones() + n * Period * velocity, Period);
    EXPECT_NEAR((v - velocity).norm(), 0.0, 1e-11); // positions around 1 mm rounded, over 1 ms
  }
}

TEST(VelocityEstimate, FilteredVelocityConvergesWithoutOvershoot)
{
  VelocityEstimate estimate(0.003);
  for (int n = 0; n < 200; ++n)
  {
    EXPECT_LE(estimate.Update({0.1 * n, 0.0, 0.0}, Period)[0], 100.0 + 1e-9);
  }
  // After 66 time constants.
  EXPECT_NEAR(estimate.Velocity()[0], 100.0, 1e-9);
}

TEST(VelocityEstimate, SpreadsAnEncoderCount)
{
  VelocityEstimate estimate(0.003);
  for (int n = 0; n < 10; ++n)
  {
    estimate.Update(Vector3::Zero(), Period);
  }
  // 0.05 mm in 1 ms, times 1 / (3 + 1).
  EXPECT_NEAR(estimate.Update({0.05, 0.0, 0.0}, Period)[0], 12.5, 1e-12);
}

TEST(VelocityEstimate, GainIsAtMostOne)
{
  // The largest output velocity is at most the largest unfiltered difference of the input.
  test::Random random(51);
  VelocityEstimate estimate(0.002);
  Vector3 last = Vector3::Zero();
  estimate.Update(last, Period);
  for (int n = 0; n < 10'000; ++n)
  {
    last += 0.1 * test::RandomDirection(random);
    EXPECT_LE(estimate.Update(last, Period).norm(), 0.1 / Period * (1.0 + 1e-9));
  }
}

TEST(VelocityEstimate, RestartsAfterNonFiniteInput)
{
  test::Random random(52);
  VelocityEstimate estimate(0.003);
  for (int n = 0; n < 10'000; ++n)
  {
    ASSERT_TRUE(
        estimate.Update(test::HostileVector(random), test::HostileNumber(random)).allFinite());
  }
  estimate.Update({test::NotANumber, 0.0, 0.0}, Period);
  EXPECT_EQ(estimate.Update({5.0, 0.0, 0.0}, Period), Vector3::Zero());
  EXPECT_GT(estimate.Update({6.0, 0.0, 0.0}, Period)[0], 0.0);
}
} // namespace
} // namespace palpate::velocity_estimate_test
