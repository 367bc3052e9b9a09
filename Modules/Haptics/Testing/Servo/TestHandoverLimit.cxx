#include "HandoverLimit.h"

#include <gtest/gtest.h>

namespace palpate::handover_limit_test
{
namespace
{
const Vector3 Hand(1.0, 2.0, -4.0);
const Eigen::Quaterniond Turn(Eigen::AngleAxisd(0.7, Vector3(1.0, 2.0, 3.0).normalized()));
const ToolWrench Before{{0.0, 0.0, 2.0}, {30.0, 0.0, 0.0}};
const ToolWrench Larger{{0.0, 3.0, 0.0}, {0.0, 0.0, -80.0}}; // of the next scene
constexpr double Stiffness = 0.5;                            // N/mm
constexpr double Gyration = 6.0;                             // mm
constexpr double Tick = 0.001;                               // s

Eigen::Quaterniond Turned(double angle, const Vector3& axis)
{
  return Eigen::AngleAxisd(angle, axis) * Turn;
}

TEST(HandoverLimit, RestingHandKeepsForceAndTorqueWhateverIsAskedFor)
{
  HandoverLimit limit(Before, Hand, Turn);
  for (int n = 0; n < 1000; ++n)
  {
    const ToolWrench felt = limit.Limited(Larger, Stiffness, Gyration, Hand, Turn, Tick);
    EXPECT_LT((felt.Force - Vector3(0.0, 2.0, 0.0)).norm(), 1e-12);
    EXPECT_LT((felt.Torque - Vector3(0.0, 0.0, -30.0)).norm(), 1e-12);
  }
  EXPECT_FALSE(limit.IsOver());
}

TEST(HandoverLimit, NoTorqueBeforeIsNoneAfter)
{
  HandoverLimit limit({Before.Force, Vector3::Zero()}, Hand, Turn);
  EXPECT_EQ(limit.Limited(Larger, Stiffness, Gyration, Hand, Turn, Tick).Torque.norm(), 0.0);
}

TEST(HandoverLimit, TurningOnRaisesTheTorqueByItsSpringAndTurningBackLowersIt)
{
  HandoverLimit limit(Before, Hand, Turn);
  // Against a torque about -z the hand turns on about +z.
  const Eigen::Quaterniond on = Turned(0.1, Vector3::UnitZ());
  const ToolWrench felt = limit.Limited(Larger, Stiffness, Gyration, Hand, on, Tick);
  EXPECT_NEAR(felt.Torque.norm(), 30.0 + Stiffness * Gyration * Gyration * 0.1, 1e-9);
  // What touches beside the origin is shifted by no more than half.
  EXPECT_NEAR(felt.Force.norm(), 2.0 + 0.5 * Stiffness * Gyration * 0.1, 1e-9);
  const ToolWrench back = limit.Limited(Larger, Stiffness, Gyration, Hand, Turn, Tick);
  EXPECT_NEAR(back.Torque.norm(), 30.0, 1e-9);
  EXPECT_NEAR(back.Force.norm(), 2.0, 1e-9);
}

// A contact beside the tool's origin, pushed on by `deeper` mm along its normal, changes both by
// less than what the limits rise by: so it is felt in full.
TEST(HandoverLimit, PushingOnIsFeltInFullWhereverTheToolTouches)
{
  for (const double arm : {0.0, 1.0, 3.0, 6.0, 9.0, 30.0})
  {
    const double share = 1.0 / (1.0 + arm * arm / (Gyration * Gyration));
    const Vector3 arms = arm * Vector3::UnitX();
    const auto pushed = [&](double deep)
    {
      const Vector3 force = Stiffness * share * deep * Vector3::UnitZ();
      return ToolWrench{force, arms.cross(force)};
    };
    HandoverLimit limit(pushed(1.0), Hand, Turn);
    for (int n = 1; n <= 100; ++n)
    {
      const ToolWrench wanted = pushed(1.0 + 0.02 * n);
      const Vector3 hand = Hand - 0.02 * n * Vector3::UnitZ();
      const ToolWrench felt = limit.Limited(wanted, Stiffness, Gyration, hand, Turn, 0.0);
      EXPECT_LT((felt.Force - wanted.Force).norm(), 1e-9) << arm;
      EXPECT_LT((felt.Torque - wanted.Torque).norm(), 1e-9) << arm;
    }
  }
}

TEST(HandoverLimit, EndsForEachWhenNotNeededForAWhile)
{
  HandoverLimit limit(Before, Hand, Turn);
  const ToolWrench twisted{Vector3::Zero(), Larger.Torque};
  for (int n = 0; n < 300; ++n)
  {
    limit.Limited(twisted, Stiffness, Gyration, Hand, Turn, Tick);
  }
  const ToolWrench felt = limit.Limited(Larger, Stiffness, Gyration, Hand, Turn, Tick);
  EXPECT_EQ(felt.Force, Larger.Force);
  EXPECT_NEAR(felt.Torque.norm(), 30.0, 1e-9);
  EXPECT_TRUE(HandoverLimit().IsOver());
  EXPECT_EQ(HandoverLimit().Limited(Larger, Stiffness, Gyration, Hand, Turn, Tick).Torque,
            Larger.Torque);
}
} // namespace
} // namespace palpate::handover_limit_test
