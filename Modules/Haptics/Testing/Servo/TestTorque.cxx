#include "SafetyCases.h"
#include "SafetyChain.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace palpate::torque_test
{
namespace
{
SafetySettings Settings()
{
  SafetySettings settings;
  settings.MaximumForce = 8.0;
  settings.MaximumTorque = 200.0;
  settings.TurnLength = 25.0;
  settings.LargestDamping = 0.02;
  settings.RampDuration = 0.1;
  settings.MaximumSlew = 2000.0; // N/s: all of the force, and of the torque, in 4 ms
  return settings;
}

// A chain of healthy ticks at one place.
class ChainRun
{
public:
  explicit ChainRun(const SafetySettings& settings = Settings()) : Chain(settings) {}

  Vector3 Tick(const Vector3& force, const Vector3& torque)
  {
    SafetyInput input;
    input.Observed = test::HealthyTick(this->Ticks++, Vector3::Zero());
    input.Observed.Sample.Orientation = {std::sin(0.5 * this->Angle), 0.0, 0.0,
                                         std::cos(0.5 * this->Angle)};
    input.IsTouching = true;
    input.ContactForce = force;
    input.ContactTorque = torque;
    this->Force = this->Chain.Apply(input);
    return this->Chain.Torque();
  }
  Vector3 Rest(const Vector3& force, const Vector3& torque)
  {
    for (int n = 0; n < 300; ++n)
    {
      this->Tick(force, torque);
    }
    return this->Chain.Torque();
  }

  SafetyChain Chain;
  Vector3 Force = Vector3::Zero();
  double Angle = 0.0; // rad, about x
  std::uint64_t Ticks = 0;
};

const Vector3 Push(0.0, 0.0, 2.0);
const Vector3 Turn(50.0, 0.0, 0.0);

TEST(Torque, PassesUnchangedWithinItsLimits)
{
  ChainRun run;
  EXPECT_EQ(run.Rest(Push, Turn), Turn);
}

TEST(Torque, IsNoneWhereTheDeviceShowsNone)
{
  SafetySettings settings = Settings();
  settings.MaximumTorque = 0.0;
  ChainRun run(settings);
  EXPECT_EQ(run.Rest(Push, Turn).norm(), 0.0);
  EXPECT_EQ(run.Force, Push);
}

TEST(Torque, IsScaledWithAForceThatIsLimitedAndNeverLongerThanItsOwnLimit)
{
  ChainRun run;
  EXPECT_LE((run.Rest(8.0 * Push, Turn) - 0.5 * Turn).norm(), 1e-9);
  EXPECT_NEAR(run.Rest(Push, 100.0 * Turn).norm(), 200.0, 1e-9);
}

TEST(Torque, FadesInAndStepsAreSpreadOut)
{
  ChainRun run;
  Vector3 last = Vector3::Zero();
  double largest = 0.0;
  for (int n = 0; n < 50; ++n)
  {
    const Vector3 now = run.Tick(Push, Turn);
    largest = std::max(largest, (now - last).norm());
    last = now;
  }
  EXPECT_LT(last.norm(), 0.6 * Turn.norm()) << "half of the ramp";
  EXPECT_GT(last.norm(), 0.4 * Turn.norm());
  run.Rest(Push, Turn);
  EXPECT_NEAR((run.Tick(Push, -3.0 * Turn) - Turn).norm(), 50.0, 1e-9) << "a quarter of all";
}

TEST(Torque, WorkOfATorqueIsInTheEnergyOfItsContact)
{
  ChainRun run;
  run.Rest(Push, Turn);
  const double before = run.Chain.Report().Energy;
  for (int n = 0; n < 100; ++n)
  {
    run.Angle -= 0.001; // against the torque
    run.Tick(Push, Turn);
  }
  EXPECT_NEAR(run.Chain.Report().Energy - before, 50.0 * 0.1, 1e-9);
  EXPECT_FALSE(run.Chain.Report().IsDamping);
}

TEST(Torque, TurnThatReturnsMoreThanItTookIsDampedByATorque)
{
  ChainRun run;
  run.Rest(Push, Turn);
  for (int n = 0; n < 10; ++n)
  {
    run.Angle += 0.001; // with the torque, at one rad/s
    run.Tick(Push, Turn);
  }
  EXPECT_LT(run.Chain.Report().Energy, 0.0);
  EXPECT_TRUE(run.Chain.Report().IsDamping);
  EXPECT_NEAR(run.Chain.Torque().x(), 50.0 - 0.02 * 25.0 * 25.0, 1e-9);
  EXPECT_EQ(run.Force, Push) << "it does not move";
}

TEST(Torque, MechanismsLossInTurnsIsCredited)
{
  SafetySettings settings = Settings();
  settings.DeviceDamping = 0.002; // 1.25 N mm s/rad of turns
  ChainRun run(settings);
  run.Rest(Push, Vector3::Zero());
  for (int n = 0; n < 1000; ++n)
  {
    run.Angle += 0.001;
    run.Tick(Push, Vector3::Zero());
  }
  EXPECT_NEAR(run.Chain.Report().Energy, 1.25, 0.01) << "but for the first ticks of its filter";
  EXPECT_LE(run.Chain.Report().Energy, 1.25);
}

TEST(Torque, IsZeroInTheTickOfAnyFault)
{
  ChainRun failed;
  failed.Rest(Push, Turn);
  failed.Chain.Fail(SafetyFault::SwitchedOff);
  EXPECT_EQ(failed.Tick(Push, Turn).norm(), 0.0);
  EXPECT_EQ(failed.Force.norm(), 0.0);

  ChainRun broken;
  broken.Rest(Push, Turn);
  EXPECT_EQ(broken.Tick(Push, {std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}).norm(), 0.0);
  EXPECT_EQ(broken.Force.norm(), 0.0);
  EXPECT_EQ(broken.Chain.Report().Fault, SafetyFault::NonFiniteForce);
}
} // namespace
} // namespace palpate::torque_test
