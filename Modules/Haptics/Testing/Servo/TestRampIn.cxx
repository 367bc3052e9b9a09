#include "RampIn.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::ramp_in_test
{
namespace
{
TEST(RampIn, RisesLinearlyFromZeroToOneAndStays)
{
  RampIn ramp(0.01);
  EXPECT_EQ(ramp.Advance(0.001), 0.0);
  for (int n = 1; n < 10; ++n)
  {
    EXPECT_NEAR(ramp.Advance(0.001), 0.1 * n, 1e-12); // a sum of ten roundings
  }
  ramp.Advance(0.0011);
  EXPECT_FALSE(ramp.IsRamping());
  EXPECT_EQ(ramp.Advance(0.001), 1.0);
}

TEST(RampIn, RestartsFromZero)
{
  RampIn ramp(0.01);
  ramp.Advance(1.0);
  ramp.Advance(1.0);
  ramp.Restart();
  EXPECT_TRUE(ramp.IsRamping());
  EXPECT_EQ(ramp.Advance(0.005), 0.0);
}

TEST(RampIn, StaysWithinZeroAndOneForAnyPeriod)
{
  test::Random random(32);
  RampIn ramp(0.5);
  for (int n = 0; n < 1000; ++n)
  {
    const double factor = ramp.Advance(test::HostileNumber(random));
    EXPECT_GE(factor, 0.0);
    EXPECT_LE(factor, 1.0);
  }
  EXPECT_EQ(RampIn(0.0).Advance(0.001), 1.0);
}
} // namespace
} // namespace palpate::ramp_in_test
