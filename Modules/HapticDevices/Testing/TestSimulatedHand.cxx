#include "SimulatedHand.h"
#include "SimulatedWrist.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace palpate::simulated_hand_test
{
namespace
{
constexpr double Step = 1e-5; // s

TEST(SimulatedHand, EnergiesBalance)
{
  test::Random random(1);
  SimulatedHand hand(HandProperties(), Vector3::Zero());
  double turnover = 0.0;
  for (int n = 0; n < 20'000; ++n)
  {
    const Vector3 force = 5.0 * test::RandomDirection(random);
    const Vector3 target = 3.0 * test::RandomDirection(random);
    const HandEnergy before = hand.Energy();
    hand.Advance(target, 100.0 * test::RandomDirection(random), force, Step);
    const HandEnergy& e = hand.Energy();
    turnover += std::abs(e.HandWork - before.HandWork) + std::abs(e.MotorWork - before.MotorWork);
    // Friction opposes the velocity at the step's end; if it reversed within the step, a path of at
    // most (10 us)^2 10 N / 0.25 kg counts against 0.2 N with the wrong sign.
    ASSERT_GE(e.FrictionLoss - before.FrictionLoss, -1e-6);
    ASSERT_GE(e.DampingLoss, before.DampingLoss);
    // Rounding of sums of this size.
    ASSERT_NEAR(e.HandWork + e.MotorWork, e.DampingLoss + e.FrictionLoss + e.Motion,
                1e-12 * (1.0 + turnover));
  }
  EXPECT_GT(turnover, 1.0);
}

TEST(SimulatedHand, ComesToRestAtEquilibrium)
{
  HandProperties properties;
  properties.Friction = 0.0;
  SimulatedHand hand(properties, Vector3::Zero());
  const Vector3 target(10.0, 0.0, -5.0);
  const Vector3 force(0.0, 2.0, 0.0);
  for (int n = 0; n < 200'000; ++n)
  {
    hand.Advance(target, Vector3::Zero(), force, Step);
  }
  // Two seconds are some thirty time constants of the damping.
  const Vector3 expected = target + force / properties.HandStiffness;
  EXPECT_NEAR((hand.Position() - expected).norm(), 0.0, 1e-9);
}

TEST(SimulatedHand, OscillatesAtNaturalFrequency)
{
  HandProperties properties;
  properties.Friction = 0.0;
  properties.Damping = 0.0;
  properties.HandDamping = 0.0;
  SimulatedHand hand(properties, Vector3::UnitX());
  // 0.5 N/mm on 0.25 kg: sqrt(2000) rad/s; a quarter of a period later it is at the centre.
  const double quarter = 0.5 * M_PI / std::sqrt(2000.0);
  const int steps = static_cast<int>(std::lround(quarter / Step));
  for (int n = 0; n < steps; ++n)
  {
    hand.Advance(Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), quarter / steps);
  }
  // The explicit spring adds energy of first order in step times frequency, 5e-4.
  EXPECT_NEAR(hand.Position()[0], 0.0, 1e-3);
}

TEST(SimulatedHand, WristTurnsAboutAnAxisAsAMassMovesAlongALine)
{
  const Vector3 axis = Vector3(1.0, -2.0, 0.5).normalized();
  SimulatedHand hand(WristProperties(), Vector3::Zero());
  SimulatedWrist wrist(WristProperties(), Eigen::Quaterniond::Identity());
  for (int n = 0; n < 50'000; ++n)
  {
    const double target = 0.8 * std::sin(1e-3 * n);
    const Vector3 torque = 50.0 * std::cos(7e-4 * n) * axis;
    hand.Advance(target * axis, Vector3::Zero(), torque, Step);
    wrist.Advance(Eigen::Quaterniond(Eigen::AngleAxisd(target, axis)), Vector3::Zero(), torque,
                  Step);
  }
  EXPECT_GT(hand.Position().norm(), 0.01);
  const Eigen::AngleAxisd turned(wrist.Orientation());
  EXPECT_NEAR((turned.angle() * turned.axis() - hand.Position()).norm(), 0.0, 1e-9); // roundings
  EXPECT_NEAR(wrist.Energy().TakenIn(), hand.Energy().TakenIn(), 1e-6);
}

TEST(SimulatedHand, FrictionHoldsAgainstSmallForce)
{
  HandProperties properties;
  SimulatedHand hand(properties, Vector3::Zero());
  for (int n = 0; n < 1000; ++n)
  {
    hand.Advance(Vector3::Zero(), Vector3::Zero(), {0.19, 0.0, 0.0}, Step);
  }
  EXPECT_EQ(hand.Position(), Vector3::Zero());
}
} // namespace
} // namespace palpate::simulated_hand_test
