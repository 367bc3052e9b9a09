#include "FalconPackets.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace palpate::motor_values_test
{
namespace
{
Vector3 VectorOf(const FalconNumbers& motors)
{
  return {static_cast<double>(motors[0]), static_cast<double>(motors[1]),
          static_cast<double>(motors[2])};
}

TEST(MotorValues, RoundsTorquesBelowLimit)
{
  EXPECT_EQ(MotorValuesFor({-10.0, 20.0, 0.1}, 6.0), (FalconNumbers{60, -120, -1}));
  EXPECT_EQ(MotorValuesFor({-682.5, 0.0, 0.0}, 6.0), (FalconNumbers{4095, 0, 0}));
}

TEST(MotorValues, SaturationKeepsDirection)
{
  test::Random random(31);
  for (int i = 0; i < 10000; ++i)
  {
    const double size = std::pow(10.0, static_cast<double>(random() % 300));
    const Vector3 torques = 1e4 * size * test::RandomDirection(random);
    const Vector3 motors = VectorOf(MotorValuesFor(torques, 6.6));
    ASSERT_EQ(motors.cwiseAbs().maxCoeff(), 4095.0);
    // Rounding by half a value of 4095 along each leg.
    ASSERT_LT((motors.normalized() + torques.stableNormalized()).norm(), std::sqrt(0.75) / 4095.0);
  }
}

TEST(MotorValues, NanIsZero)
{
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinite = std::numeric_limits<double>::infinity();
  EXPECT_EQ(MotorValuesFor({nan, 1.0, 1.0}, 6.6), FalconNumbers{});
  EXPECT_EQ(MotorValuesFor({1.0, infinite, 1.0}, 6.6), FalconNumbers{});
  EXPECT_EQ(MotorValuesFor({1.0, 1.0, 1.0}, nan), FalconNumbers{});
}
} // namespace
} // namespace palpate::motor_values_test
