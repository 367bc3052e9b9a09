#include "SafetyChain.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

#include <string>

namespace palpate
{
namespace
{
SafetySettings Settings()
{
  SafetySettings settings;
  settings.MaximumForce = 8.0;
  settings.RampDuration = 0.01;
  settings.LargestDamping = 0.02;
  return settings;
}

SafetyInput Pushing(std::uint64_t n, const Vector3& force)
{
  SafetyInput input;
  input.Observed = test::HealthyTick(n);
  input.IsTouching = true;
  input.ContactForce = force;
  return input;
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

TEST(SafetyChain, LetsASteadyForceThroughOnceItHasFadedIn)
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
    }
    else
    {
      // 2000 N/s; hostile times stay below the 10 ms at which a gap becomes a fault.
      ASSERT_LE((out - last).norm(), 20.0 + 1e-12);
      forces += out.isZero(0.0) ? 0 : 1;
    }
    last = out;
  }
  EXPECT_GT(forces, 100'000); // the chain is no wall
}

TEST(SafetyChain, StaysAtZeroAfterAFaultUntilItIsRearmed)
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

TEST(SafetyChain, NamesTheFirstFault)
{
  SafetyChain chain = Running(30, Vector3::UnitX());
  SafetyInput input = Pushing(30, Vector3::UnitX());
  input.SceneFault = SafetyFault::InvalidContact;
  EXPECT_EQ(chain.Apply(input), Vector3::Zero());
  chain.Fail(SafetyFault::DeviceFailed);
  EXPECT_EQ(chain.Report().Fault, SafetyFault::InvalidContact);
}

TEST(SafetyChain, GivesNothingBeforeTheDeviceIsReady)
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

TEST(SafetyChain, DampsAContactThatGivesOutEnergy)
{
  SafetyChain chain = Running(30, {0.0, 0.0, 2.0});
  SafetyInput input = Pushing(30, {0.0, 0.0, 2.0});
  // Pushed along: the contact works on the hand.
  input.Observed.Sample.Position = Vector3(0.0, 0.0, 0.05);
  const Vector3 out = chain.Apply(input);
  EXPECT_TRUE(chain.Report().IsDamping);
  EXPECT_NEAR(chain.Report().Energy, -0.1, 1e-12); // roundings
  EXPECT_NEAR(out[2], 2.0 - 0.02 * 50.0, 1e-12);   // as much as the device bears; the same
}

TEST(SafetyChain, AmbientForcesAreNoContactsEnergy)
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

TEST(SafetyChain, EveryFaultHasItsOwnSentence)
{
  std::vector<std::string> sentences;
  for (int fault = 0; fault <= static_cast<int>(SafetyFault::InvalidContact); ++fault)
  {
    const std::string text = Describe(static_cast<SafetyFault>(fault));
    EXPECT_EQ(text.back(), '.');
    EXPECT_EQ(std::count(sentences.begin(), sentences.end(), text), 0);
    sentences.push_back(text);
  }
}
} // namespace
} // namespace palpate
