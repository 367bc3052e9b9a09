#include "SafetyChain.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

#include <set>
#include <string>

namespace palpate::safety_chain_test
{
namespace
{
using test::Pushing;

SafetySettings Settings()
{
  SafetySettings settings;
  settings.MaximumForce = 8.0;
  settings.RampDuration = 0.01;
  settings.LargestDamping = 0.02;
  return settings;
}

// A chain after `ticks` healthy ticks with a push.
SafetyChain Running(std::uint64_t ticks, const Vector3& force)
{
  SafetyChain chain(Settings());
  for (std::uint64_t n = 0; n < ticks; ++n)
  {
    static_cast<void>(chain.Apply(Pushing(n, force)));
  }
  return chain;
}

TEST(SafetyChain, PassesASteadyForceAfterFadingIn)
{
  const Vector3 force(1.0, 2.0, -3.0);
  SafetyChain chain = Running(20, force);
  EXPECT_EQ(chain.Apply(Pushing(20, force)), force);
  EXPECT_TRUE(chain.Report().IsArmed);
  EXPECT_FALSE(chain.Report().IsRamping);
}

TEST(SafetyChain, AnyInputGivesAFiniteForceWithinTheLimits)
{
  test::Random random(41);
  std::uniform_int_distribution<int> chance(0, 99);
  SafetyChain chain(Settings());
  Vector3 last = Vector3::Zero();
  std::int64_t lastStarted = 0;
  bool wasArmed = false;
  int forces = 0;
  for (std::uint64_t n = 0; n < 200'000; ++n)
  {
    SafetyInput input = Pushing(n, 3.0 * test::VectorOfAnyLength(random));
    input.IsTouching = chance(random) < 60;
    input.AmbientForce = 0.1 * test::RandomDirection(random);
    if (chance(random) < 2)
    {
      input.ContactForce = test::HostileVector(random);
      input.AmbientForce = test::HostileVector(random);
      input.Observed.Sample.Position = test::HostileVector(random);
      input.Observed.Tick.Started += chance(random) * test::TickPeriod - 50 * test::TickPeriod;
    }
    const Vector3 out = chain.Apply(input);
    ASSERT_TRUE(out.allFinite());
    ASSERT_LE(out.norm(), 8.0);
    if (chain.Report().Fault != SafetyFault::None)
    {
      ASSERT_EQ(out, Vector3::Zero());
      chain.Rearm();
      wasArmed = false;
    }
    else
    {
      const std::int64_t started = input.Observed.Tick.Started;
      const double passed = wasArmed ? 1e-9 * static_cast<double>(started - lastStarted) : 0.0;
      // 2000 N/s; forces of 8 N are rounded.
      ASSERT_LE((out - last).norm(), 2000.0 * passed + 1e-12);
      lastStarted = started;
      wasArmed = true;
      forces += out.isZero(0.0) ? 0 : 1;
    }
    last = out;
  }
  EXPECT_GT(forces, 100'000); // the chain is no wall
}

TEST(SafetyChain, StaysAtZeroAfterAFaultUntilRearmed)
{
  const Vector3 force(0.0, 0.0, 2.0);
  SafetyChain chain = Running(30, force);
  EXPECT_EQ(chain.Apply(Pushing(30, {test::NotANumber, 0.0, 0.0})), Vector3::Zero());
  for (std::uint64_t n = 31; n < 100; ++n)
  {
    ASSERT_EQ(chain.Apply(Pushing(n, force)), Vector3::Zero());
    ASSERT_EQ(chain.Report().Fault, SafetyFault::NonFiniteForce);
  }
  chain.Rearm();
  EXPECT_EQ(chain.Apply(Pushing(100, force)), Vector3::Zero());
  double last = 0.0;
  for (std::uint64_t n = 101; n < 109; ++n)
  {
    const double push = chain.Apply(Pushing(n, force)).norm();
    EXPECT_GT(push, last);
    EXPECT_LT(push, 2.0);
    last = push;
  }
}

TEST(SafetyChain, ReportsTheFirstFault)
{
  SafetyChain chain = Running(30, Vector3::UnitX());
  SafetyInput input = Pushing(30, Vector3::UnitX());
  input.SceneFault = SafetyFault::InvalidContact;
  EXPECT_EQ(chain.Apply(input), Vector3::Zero());
  chain.Fail(SafetyFault::DeviceFailed);
  EXPECT_EQ(chain.Report().Fault, SafetyFault::InvalidContact);
}

TEST(SafetyChain, ForceReversesNoFasterThanTheSlewRate)
{
  SafetySettings settings = Settings();
  settings.RampDuration = 0.0;
  settings.MaximumSlew = 500.0; // 0.5 N per tick
  SafetyChain chain(settings);
  static_cast<void>(chain.Apply(Pushing(0, {0.0, 0.0, 8.0})));
  for (std::uint64_t n = 1; n < 48; ++n)
  {
    const bool isUp = n <= 16;
    const Vector3 out = chain.Apply(Pushing(n, {0.0, 0.0, isUp ? 8.0 : -8.0}));
    const double expected = 0.5 * static_cast<double>(n) - (isUp ? 0.0 : 1.0 * (n - 16));
    EXPECT_NEAR(out[2], expected, 1e-12); // roundings of 8 N
  }
  EXPECT_TRUE(chain.Report().IsSlewing);
  EXPECT_EQ(chain.Apply(Pushing(49, {0.0, 0.0, -8.0}))[2], -8.0);
  EXPECT_FALSE(chain.Report().IsSlewing);
}

TEST(SafetyChain, LimitedForceFallsAtTheSlewRate)
{
  SafetyChain chain = Running(100, {0.0, 0.0, 1000.0});
  EXPECT_EQ(chain.Apply(Pushing(100, {0.0, 0.0, 1000.0})).norm(), 8.0 * (1.0 - 1e-15));
  EXPECT_TRUE(chain.Report().IsLimited);
  // 2 N per tick: the part cut by the limit does not have to be slewed.
  EXPECT_NEAR(chain.Apply(Pushing(101, Vector3::Zero()))[2], 6.0, 1e-12);
  EXPECT_FALSE(chain.Report().IsLimited);
}

TEST(SafetyChain, NonFiniteAmbientForceIsAFault)
{
  for (const double bad : {test::NotANumber, test::Infinite, 2e6})
  {
    SafetyChain chain = Running(30, Vector3::UnitX());
    SafetyInput input = Pushing(30, Vector3::UnitX());
    input.AmbientForce[1] = bad;
    EXPECT_EQ(chain.Apply(input), Vector3::Zero());
    EXPECT_EQ(chain.Report().Fault, SafetyFault::NonFiniteForce) << bad;
  }
}

TEST(SafetyChain, AmbientForcesFadeIn)
{
  SafetyChain chain(Settings());
  for (std::uint64_t n = 0; n <= 10; ++n)
  {
    SafetyInput input;
    input.Observed = test::HealthyTick(n);
    input.AmbientForce = Vector3::UnitY();
    // 10 ticks of ramp; a sum of ten roundings.
    EXPECT_NEAR(chain.Apply(input)[1], 0.1 * static_cast<double>(n), 1e-12);
  }
}

TEST(SafetyChain, CreditsMechanismDampingAndFriction)
{
  SafetySettings settings = Settings();
  settings.LargestDamping = 0.0; // observed only
  settings.DeviceDamping = 0.003;
  settings.DeviceFriction = 0.2;
  SafetyChain chain(settings);
  double before = 0.0;
  double after = 0.0;
  for (std::uint64_t n = 0; n < 200; ++n)
  {
    SafetyInput input = Pushing(n, Vector3::UnitZ());
    input.Observed.Sample.Position = Vector3(0.0, 0.0, 0.05 * static_cast<double>(n));
    static_cast<void>(chain.Apply(input));
    before = after;
    after = chain.Report().Energy;
  }
  // At 50 mm/s, in 1 ms: 1 N gave out 0.05 N mm; 0.003 N s/mm and 0.2 N took up the rest. The
  // velocity's filter has settled after 200 ticks of a time constant of 3.
  EXPECT_NEAR(after - before, -0.05 + (0.003 * 50.0 + 0.2) * 0.05, 1e-9);
}

TEST(SafetyChain, CountsEnergyUntilTheLastForceOfAContact)
{
  SafetyChain chain(Settings());
  const auto touch = [&chain](std::uint64_t n, double z, double push)
  {
    SafetyInput input = Pushing(n, {0.0, 0.0, push});
    input.IsTouching = push > 0.0;
    input.Observed.Sample.Position = Vector3(0.0, 0.0, z);
    static_cast<void>(chain.Apply(input));
    return chain.Report().Energy;
  };
  for (std::uint64_t n = 0; n < 20; ++n)
  {
    touch(n, 0.0, 3.0);
  }
  // In by 0.1 mm against 3 N; then out, while the last tick's force is still held, and the slew
  // limit releases 2 N per tick.
  EXPECT_NEAR(touch(20, -0.1, 3.0), 0.3, 1e-12);
  EXPECT_NEAR(touch(21, 0.0, 0.0), 0.0, 1e-12);
  EXPECT_NEAR(touch(22, 0.1, 0.0), -0.1, 1e-12);
  EXPECT_EQ(touch(23, 0.1, 0.0), 0.0);
}

TEST(SafetyChain, RearmForgetsTheLastTick)
{
  SafetySettings settings = Settings();
  settings.RampDuration = 0.0;
  SafetyChain chain(settings);
  for (std::uint64_t n = 0; n < 20; ++n)
  {
    static_cast<void>(chain.Apply(Pushing(n, {0.0, 0.0, 6.0})));
  }
  chain.Fail(SafetyFault::SwitchedOff);
  std::uint64_t n = 20;
  for (; n < 1020; ++n)
  {
    ASSERT_EQ(chain.Apply(Pushing(n, {0.0, 0.0, 6.0})), Vector3::Zero());
  }
  chain.Rearm();
  // In the second that has passed the force could not change.
  SafetyInput elsewhere = Pushing(n, {0.0, 0.0, 6.0});
  elsewhere.Observed.Sample.Position = Vector3(0.0, 0.0, 30.0);
  EXPECT_EQ(chain.Apply(elsewhere), Vector3::Zero());
  EXPECT_EQ(chain.Report().Energy, 0.0);
  elsewhere.Observed.Tick.Started += test::TickPeriod;
  elsewhere.Observed.Sample.Time += test::TickPeriod;
  ++elsewhere.Observed.Sample.Sequence;
  EXPECT_NEAR(chain.Apply(elsewhere)[2], 2.0, 1e-12);
}

TEST(SafetyChain, RearmForgetsContactEnergy)
{
  SafetyChain chain = Running(30, {0.0, 0.0, 2.0});
  SafetyInput input = Pushing(30, {0.0, 0.0, 2.0});
  input.Observed.Sample.Position = Vector3(0.0, 0.0, -0.5); // 1 N mm absorbed
  static_cast<void>(chain.Apply(input));
  EXPECT_NEAR(chain.Report().Energy, 1.0, 1e-12);
  chain.Fail(SafetyFault::SwitchedOff);
  chain.Rearm();
  input.Observed.Tick = test::HealthyTick(31).Tick;
  input.Observed.Sample.Time = input.Observed.Tick.Started;
  ++input.Observed.Sample.Sequence;
  EXPECT_EQ(chain.Apply(input), Vector3::Zero());
  EXPECT_TRUE(chain.Report().IsRamping);
  EXPECT_EQ(chain.Report().Energy, 0.0);
}

TEST(SafetyChain, PassesNoForceBeforeTheDeviceIsReady)
{
  SafetyChain chain(Settings());
  for (std::uint64_t n = 0; n < 50; ++n)
  {
    SafetyInput input = Pushing(n, Vector3::UnitX());
    input.Observed.State = DeviceState::Homing;
    EXPECT_EQ(chain.Apply(input), Vector3::Zero());
    EXPECT_FALSE(chain.Report().IsArmed);
    EXPECT_EQ(chain.Report().Fault, SafetyFault::None);
  }
}

TEST(SafetyChain, DampsAnActiveContact)
{
  SafetyChain chain = Running(30, {0.0, 0.0, 2.0});
  SafetyInput input = Pushing(30, {0.0, 0.0, 2.0});
  // Pushed in its direction: the contact does work on the hand.
  input.Observed.Sample.Position = Vector3(0.0, 0.0, 0.05);
  const Vector3 out = chain.Apply(input);
  EXPECT_TRUE(chain.Report().IsDamping);
  EXPECT_NEAR(chain.Report().Energy, -0.1, 1e-12); // roundings
  EXPECT_NEAR(out[2], 2.0 - 0.02 * 50.0, 1e-12);   // the device's limit; the same
}

TEST(SafetyChain, AmbientForcesAreNotObserved)
{
  SafetyChain chain(Settings());
  for (std::uint64_t n = 0; n < 100; ++n)
  {
    SafetyInput input;
    input.Observed = test::HealthyTick(n, {0.0, 0.01 * static_cast<double>(n), 0.0});
    input.AmbientForce = {0.0, 1.0, 0.0};
    static_cast<void>(chain.Apply(input));
    EXPECT_EQ(chain.Report().Energy, 0.0);
  }
}

TEST(SafetyChain, EveryFaultHasItsOwnMessage)
{
  // Values after the last fault are none; a new one must be counted here too.
  constexpr int count = static_cast<int>(SafetyFault::UntakenForce) + 1;
  std::set<std::string> messages{Describe(static_cast<SafetyFault>(count))};
  EXPECT_EQ(*messages.begin(), "An unknown fault.");
  for (int fault = 0; fault < count; ++fault)
  {
    const std::string text = Describe(static_cast<SafetyFault>(fault));
    EXPECT_EQ(text.back(), '.');
    EXPECT_TRUE(messages.insert(text).second) << text;
  }
  for (const SafetyFault fault :
       {SafetyFault::StalledTick, SafetyFault::StaleSample, SafetyFault::Suspended})
  {
    const std::string text = Describe(fault, true);
    EXPECT_NE(text.find("goes on by itself"), std::string::npos);
    EXPECT_TRUE(messages.insert(text).second) << text;
  }
}
} // namespace
} // namespace palpate::safety_chain_test
