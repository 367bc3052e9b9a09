#include "EnergyObserver.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::energy_observer_test
{
namespace
{
// Forces and motions without torques and turns.
ToolWrench Push(const Vector3& force)
{
  return {force, Vector3::Zero()};
}
Twist Path(const Vector3& shift)
{
  return {shift, Vector3::Zero()};
}

TEST(EnergyObserver, ReturningSpringHasZeroBalance)
{
  EnergyObserver observer(0.02);
  // Held forces of a spring of 1 N/mm lag behind: in by 2 mm, and out again, in steps of 0.5 mm.
  const double paths[] = {0.5, 0.5, 0.5, 0.5, -0.5, -0.5, -0.5, -0.5};
  double depth = 0.0;
  for (const double path : paths)
  {
    observer.Account(Push({-depth, 0.0, 0.0}), Path({path, 0.0, 0.0}));
    depth += path;
  }
  // Worked out by hand: in 0.5 (0 + 0.5 + 1 + 1.5), out 0.5 (2 + 1.5 + 1 + 0.5).
  EXPECT_DOUBLE_EQ(observer.Energy(), 1.5 - 2.5);
}

TEST(EnergyObserver, DampingAbsorbsTheExcessInOnePeriod)
{
  EnergyObserver observer(1.0);
  observer.Account(Push({1.0, 0.0, 0.0}), Path({0.1, 0.0, 0.0}));
  ASSERT_LT(observer.Energy(), 0.0);
  const Vector3 velocity(100.0, 20.0, 0.0);
  const ToolWrench damping = observer.Damping(Push({10.0, 0.0, 0.0}), Path(velocity), 0.001);
  observer.Account(damping, Path(0.001 * velocity));
  EXPECT_NEAR(observer.Energy(), 0.0, 1e-15); // roundings of 0.1 N mm
}

TEST(EnergyObserver, PassiveContactIsNotDamped)
{
  EnergyObserver observer(1.0);
  observer.Account(Push({-1.0, 0.0, 0.0}), Path({0.1, 0.0, 0.0}));
  EXPECT_EQ(observer.Damping(Push({1.0, 0.0, 0.0}), Path({100.0, 0.0, 0.0}), 0.001).Force,
            Vector3::Zero());
}

TEST(EnergyObserver, DampingNeverPullsAndNeverExceedsItsLimit)
{
  test::Random random(33);
  for (int n = 0; n < 10'000; ++n)
  {
    EnergyObserver observer(0.02);
    observer.Account(Push(test::VectorOfAnyLength(random)), Path(test::VectorOfAnyLength(random)));
    const Vector3 contact = test::VectorOfAnyLength(random);
    const Vector3 velocity = test::VectorOfAnyLength(random);
    const Vector3 damping = observer.Damping(Push(contact), Path(velocity), 0.001).Force;
    // Roundings of products of these sizes.
    const double rounding = 1e-14 * (contact.norm() + damping.norm());
    ASSERT_GE((contact + damping).dot(contact.normalized()), -rounding);
    ASSERT_LE(damping.norm(), 0.02 * velocity.norm() + rounding);
    ASSERT_LE(damping.dot(velocity), 0.02 * rounding * velocity.norm());
  }
}

TEST(EnergyObserver, TurnsAreCountedAndDampedAsMotionsAre)
{
  constexpr double TurnLength = 25.0; // mm
  EnergyObserver observer(1.0, TurnLength);
  observer.Account({Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.0, 30.0)},
                   {Vector3(0.1, 0.0, 0.0), Vector3(0.0, 0.0, 0.02)});
  EXPECT_DOUBLE_EQ(observer.Energy(), -0.1 - 0.6);
  const Twist velocity{Vector3(20.0, 5.0, 0.0), Vector3(1.0, 0.0, 3.0)};
  const ToolWrench damping =
      observer.Damping({Vector3(10.0, 0.0, 0.0), Vector3(0.0, 0.0, 300.0)}, velocity, 0.001);
  // Equal motors behind other gears.
  EXPECT_NEAR(damping.Torque.norm() / velocity.Turn.norm(),
              TurnLength * TurnLength * damping.Force.norm() / velocity.Shift.norm(), 1e-9);
  observer.Account(damping, {0.001 * velocity.Shift, 0.001 * velocity.Turn});
  EXPECT_NEAR(observer.Energy(), 0.0, 1e-14); // roundings of 0.7 N mm
  // A hand that only turns is damped, too, and no torque is turned into its opposite.
  observer.Account({Vector3::Zero(), Vector3(0.0, 0.0, 30.0)}, {Vector3::Zero(), Vector3(0, 0, 1)});
  const Twist turning{Vector3::Zero(), Vector3(0.0, 0.0, 5.0)};
  EXPECT_EQ(observer.Damping({Vector3::Zero(), Vector3(0.0, 0.0, 20.0)}, turning, 0.001).Torque,
            Vector3(0.0, 0.0, -20.0));
  EXPECT_EQ(observer.Damping({}, turning, 0.001).Torque, Vector3::Zero());
}

TEST(EnergyObserver, NoDampingWithoutContactForce)
{
  EnergyObserver observer(0.02);
  observer.Account(Push(Vector3::UnitX()), Path(Vector3::UnitX()));
  EXPECT_EQ(observer.Damping(Push(Vector3::Zero()), Path({100.0, 0.0, 0.0}), 0.001).Force,
            Vector3::Zero());
}

TEST(EnergyObserver, IgnoresNonFiniteInput)
{
  test::Random random(34);
  EnergyObserver observer(0.02);
  for (int n = 0; n < 10'000; ++n)
  {
    observer.Account({test::HostileVector(random), test::HostileVector(random)},
                     {test::HostileVector(random), test::HostileVector(random)});
    ASSERT_FALSE(std::isnan(observer.Energy()));
  }
}

TEST(EnergyObserver, CreditsOnlyTheMechanismsLosses)
{
  EnergyObserver observer(0.02);
  observer.Credit(0.25);
  for (const double none : {-1.0, 0.0, test::NotANumber, test::Infinite})
  {
    observer.Credit(none);
  }
  EXPECT_EQ(observer.Energy(), 0.25);
}

TEST(EnergyObserver, CloseResetsTheBalance)
{
  EnergyObserver observer(0.02);
  observer.Account(Push(Vector3::UnitX()), Path(Vector3::UnitX()));
  observer.Close();
  EXPECT_EQ(observer.Energy(), 0.0);
}
} // namespace
} // namespace palpate::energy_observer_test
