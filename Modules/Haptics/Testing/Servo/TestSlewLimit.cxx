#include "SlewLimit.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::slew_limit_test
{
namespace
{
TEST(SlewLimit, NeverExceedsTheRate)
{
  test::Random random(21);
  constexpr double rate = 500.0;
  SlewLimit slew(rate);
  std::uniform_real_distribution<double> period(0.0, 0.003);
  Vector3 last = Vector3::Zero();
  for (int n = 0; n < 100'000; ++n)
  {
    const double passed = period(random);
    const Vector3 out = slew.Apply(
        n % 3 == 0 ? test::HostileVector(random) : test::VectorOfAnyLength(random), passed);
    ASSERT_TRUE(out.allFinite());
    // The difference of two forces is rounded in the last place of the larger one.
    ASSERT_LE((out - last).norm(), rate * passed + 1e-15 * (1.0 + out.norm()));
    last = out;
  }
}

TEST(SlewLimit, ReachesASteadyForceStraightAndExactly)
{
  SlewLimit slew(1000.0);
  const Vector3 wanted(3.0, -4.0, 0.0);
  for (int n = 1; n <= 5; ++n)
  {
    const Vector3 out = slew.Apply(wanted, 0.001);
    EXPECT_NEAR((out - wanted * (n / 5.0)).norm(), 0.0, 1e-12); // some roundings of 5 N
  }
  EXPECT_EQ(slew.Apply(wanted, 0.001), wanted);
  EXPECT_FALSE(slew.IsSlewing());
}

TEST(SlewLimit, StaysWithinTheBoundsOfBothEnds)
{
  test::Random random(22);
  SlewLimit slew(700.0);
  for (int n = 0; n < 10'000; ++n)
  {
    // Between two points of a sphere, up to rounding.
    EXPECT_LE(slew.Apply(5.0 * test::RandomDirection(random), 0.001).norm(), 5.0 * (1.0 + 1e-14));
  }
}

TEST(SlewLimit, AllowedChangeGivesTheExactForce)
{
  test::Random random(23);
  SlewLimit slew(1e5);
  for (int n = 0; n < 1000; ++n)
  {
    const Vector3 wanted = (1.0 + 0.01 * n) * test::RandomDirection(random); // 24 N apart at most
    EXPECT_EQ(slew.Apply(wanted, 0.001), wanted);
    EXPECT_FALSE(slew.IsSlewing());
  }
}

TEST(SlewLimit, NonFiniteForceCountsAsZero)
{
  for (const double bad : {test::NotANumber, test::Infinite})
  {
    SlewLimit slew(1000.0);
    slew.Reset({2.0, 0.0, 0.0});
    EXPECT_NEAR((slew.Apply({0.0, bad, 0.0}, 0.001) - Vector3::UnitX()).norm(), 0.0, 1e-12);
    EXPECT_EQ(slew.Apply({0.0, bad, 0.0}, 0.002), Vector3::Zero());
  }
}

TEST(SlewLimit, NothingChangesWithoutTimeOrRate)
{
  SlewLimit slew(1000.0);
  slew.Reset({1.0, 0.0, 0.0});
  for (const double period : {0.0, -1.0, test::NotANumber})
  {
    EXPECT_EQ(slew.Apply({5.0, 5.0, 5.0}, period), Vector3(1.0, 0.0, 0.0));
    EXPECT_TRUE(slew.IsSlewing());
  }
  EXPECT_EQ(SlewLimit(test::NotANumber).Apply({1.0, 0.0, 0.0}, 1.0), Vector3::Zero());
}
} // namespace
} // namespace palpate::slew_limit_test
