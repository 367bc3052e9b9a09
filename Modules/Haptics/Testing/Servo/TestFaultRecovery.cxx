// Without motors, faults of timing end by themselves; with motors, none does.
#include "FaultRecovery.h"

#include "DeviceCapabilities.h"
#include "SafetyCases.h"

#include <gtest/gtest.h>

#include <initializer_list>

namespace palpate::fault_recovery_test
{
namespace
{
constexpr double Push = 2.0;                                                // N
constexpr std::uint64_t WaitTicks = FaultRecovery::Wait / test::TickPeriod; // without a fault
constexpr std::int64_t HoldUp = WatchdogLimits().LongestGap + 2'000'000;    // ns
constexpr std::initializer_list<SafetyFault> AllFaults{
    SafetyFault::DeviceFailed,      SafetyFault::StalledTick,       SafetyFault::StaleSample,
    SafetyFault::ImplausibleMotion, SafetyFault::NonFinitePosition, SafetyFault::NonFiniteForce,
    SafetyFault::InvalidContact,    SafetyFault::SwitchedOff,       SafetyFault::Suspended,
    SafetyFault::UntakenForce};

bool IsOfTiming(SafetyFault fault)
{
  return fault == SafetyFault::StalledTick || fault == SafetyFault::StaleSample ||
         fault == SafetyFault::Suspended;
}

// A contact that pushes along z, at 1 kHz, with forces on.
class PushedHand
{
public:
  explicit PushedHand(bool hasMotors) : Chain(SettingsOf(hasMotors))
  {
    EXPECT_EQ(this->Tick(30), Push);
  }

  // A good tick.
  SafetyInput Next()
  {
    SafetyInput input = test::Pushing(this->Count++, {0.0, 0.0, Push});
    input.Observed.Tick.Started += this->Late;
    input.Observed.Tick.BootTime = input.Observed.Tick.Started + this->Slept;
    input.Observed.Sample.Time = input.Observed.Tick.Started;
    return input;
  }
  double Apply(const SafetyInput& input)
  {
    this->Now = input.Observed.Tick.Started;
    const Vector3 force = this->Chain.Apply(input);
    EXPECT_EQ(force[0], 0.0);
    EXPECT_EQ(force[1], 0.0);
    return force[2];
  }
  // Good ticks; returns the last one's force (N).
  double Tick(std::uint64_t count = 1)
  {
    double force = 0.0;
    for (std::uint64_t n = 0; n < count; ++n)
    {
      force = this->Apply(this->Next());
    }
    return force;
  }
  // Expects 0 N in so many good ticks.
  void ExpectNoForce(std::uint64_t count)
  {
    for (std::uint64_t n = 0; n < count; ++n)
    {
      ASSERT_EQ(this->Tick(), 0.0) << n;
      ASSERT_FALSE(this->Chain.Report().IsArmed);
    }
  }
  SafetyFault Fault() const { return this->Chain.Report().Fault; }

  SafetyChain Chain;
  std::int64_t Now = 0;   // ns, of the last tick
  std::int64_t Late = 0;  // ns, of every tick from now on
  std::int64_t Slept = 0; // ns, of the machine

private:
  static SafetySettings SettingsOf(bool hasMotors)
  {
    SafetySettings settings;
    settings.MaximumForce = 8.0;
    settings.RampDuration = 0.01;
    settings.HasMotors = hasMotors;
    return settings;
  }

  std::uint64_t Count = 0;
};

TEST(FaultRecovery, LateTickEndsByItselfWithoutMotors)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  EXPECT_EQ(hand.Tick(), 0.0);
  EXPECT_EQ(hand.Fault(), SafetyFault::StalledTick);
  EXPECT_TRUE(hand.Chain.Report().WillResume);
  hand.ExpectNoForce(WaitTicks);
  EXPECT_EQ(hand.Fault(), SafetyFault::StalledTick);
  EXPECT_EQ(hand.Tick(), 0.0);
  EXPECT_TRUE(hand.Chain.Report().IsArmed);
  EXPECT_FALSE(hand.Chain.Report().WillResume);
  double last = 0.0;
  for (int n = 1; n < 10; ++n)
  {
    const double force = hand.Tick();
    EXPECT_GT(force, last);
    EXPECT_LT(force, Push);
    last = force;
  }
  EXPECT_EQ(hand.Tick(2), Push);
}

TEST(FaultRecovery, NoFaultEndsByItselfWithMotors)
{
  for (const SafetyFault fault : AllFaults)
  {
    PushedHand hand(true);
    hand.Chain.Fail(fault);
    hand.ExpectNoForce(100 * WaitTicks);
    EXPECT_EQ(hand.Fault(), fault);
    EXPECT_FALSE(hand.Chain.Report().WillResume);
    hand.Chain.Rearm();
    EXPECT_EQ(hand.Tick(20), Push);
  }
}

TEST(FaultRecovery, UnknownDeviceHasMotors)
{
  EXPECT_TRUE(DeviceCapabilities().HasMotors);
  EXPECT_TRUE(SafetySettings().HasMotors);
}

TEST(FaultRecovery, OnlyFaultsOfTimingEndWithoutMotors)
{
  for (const SafetyFault fault : AllFaults)
  {
    PushedHand hand(false);
    hand.Chain.Fail(fault);
    hand.ExpectNoForce(WaitTicks);
    hand.Tick(10 * WaitTicks);
    EXPECT_EQ(hand.Fault() == SafetyFault::None, IsOfTiming(fault)) << Describe(fault);
    EXPECT_EQ(hand.Tick(), IsOfTiming(fault) ? Push : 0.0) << Describe(fault);
  }
}

TEST(FaultRecovery, RepeatedFaultsKeepForcesOff)
{
  PushedHand hand(false);
  for (int n = 0; n < 20; ++n)
  {
    hand.Late += HoldUp;
    hand.ExpectNoForce(WaitTicks);
  }
  EXPECT_EQ(hand.Tick(20), Push);
}

TEST(FaultRecovery, WaitBeginsWithNewSamples)
{
  PushedHand hand(false);
  const DeviceSample frozen = hand.Next().Observed.Sample;
  for (std::uint64_t n = 0; n < 4 * WaitTicks; ++n)
  {
    SafetyInput input = hand.Next();
    input.Observed.Sample = frozen;
    const double force = hand.Apply(input);
    ASSERT_TRUE(n < 2 || force == 0.0) << n;
  }
  EXPECT_EQ(hand.Fault(), SafetyFault::StaleSample);
  hand.ExpectNoForce(WaitTicks);
  EXPECT_EQ(hand.Tick(20), Push);
}

TEST(FaultRecovery, SuspensionEndsByItselfWithoutMotors)
{
  PushedHand hand(false);
  hand.Slept += 3'600'000'000'000;
  EXPECT_EQ(hand.Tick(), 0.0);
  EXPECT_EQ(hand.Fault(), SafetyFault::Suspended);
  hand.ExpectNoForce(WaitTicks);
  EXPECT_EQ(hand.Tick(20), Push);
}

TEST(FaultRecovery, StopByAPersonDuringTheWaitStays)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  hand.ExpectNoForce(WaitTicks / 2);
  hand.Chain.Fail(SafetyFault::SwitchedOff);
  hand.ExpectNoForce(100 * WaitTicks);
  EXPECT_EQ(hand.Fault(), SafetyFault::SwitchedOff);
  EXPECT_FALSE(hand.Chain.Report().WillResume);
}

TEST(FaultRecovery, LateTickDoesNotShortenAStopByAPerson)
{
  PushedHand hand(false);
  hand.Chain.Fail(SafetyFault::SwitchedOff);
  hand.ExpectNoForce(10);
  hand.Late += HoldUp;
  hand.ExpectNoForce(100 * WaitTicks);
  EXPECT_EQ(hand.Fault(), SafetyFault::SwitchedOff);
}

TEST(FaultRecovery, LastingFaultDuringTheWaitStays)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  hand.ExpectNoForce(WaitTicks / 2);
  SafetyInput lost = hand.Next();
  lost.Observed.State = DeviceState::Error;
  EXPECT_EQ(hand.Apply(lost), 0.0);
  hand.ExpectNoForce(100 * WaitTicks);
  EXPECT_EQ(hand.Fault(), SafetyFault::DeviceFailed);
}

TEST(FaultRecovery, NonFiniteForceAfterTheWaitIsAFault)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  for (std::uint64_t n = 0; n < 4 * WaitTicks; ++n)
  {
    SafetyInput input = hand.Next();
    input.ContactForce[2] = test::NotANumber;
    ASSERT_EQ(hand.Apply(input), 0.0);
  }
  EXPECT_EQ(hand.Fault(), SafetyFault::NonFiniteForce);
  hand.ExpectNoForce(100 * WaitTicks);
}

TEST(FaultRecovery, RearmEndsTheWait)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  hand.ExpectNoForce(WaitTicks / 2);
  hand.Chain.Rearm();
  EXPECT_EQ(hand.Tick(20), Push);
}

TEST(FaultRecovery, PauseBeginsTheWaitAgain)
{
  PushedHand hand(false);
  hand.Late += HoldUp;
  hand.ExpectNoForce(WaitTicks / 2);
  hand.Late += 10 * FaultRecovery::Wait;
  hand.Chain.Resume();
  hand.ExpectNoForce(WaitTicks);
  EXPECT_EQ(hand.Tick(20), Push);
}

// A good tick or one with a random fault, which the chain is to detect or is told of.
double TickWithAnyFault(PushedHand& hand, test::Random& random)
{
  std::uniform_int_distribution<int> kind(0, 11);
  std::uniform_int_distribution<std::int64_t> duration(0, 40'000'000);
  SafetyInput input = hand.Next();
  switch (kind(random))
  {
  case 0:
    hand.Late += duration(random);
    return hand.Apply(hand.Next());
  case 1:
    hand.Slept += duration(random);
    return hand.Apply(hand.Next());
  case 2:
    input.Observed.Sample.Time -= duration(random);
    break;
  case 3:
    input.Observed.Sample.Sequence = 1;
    break;
  case 4:
    input.Observed.Sample.Position = test::HostileVector(random);
    break;
  case 5:
    input.ContactForce = test::HostileVector(random).cwiseProduct(Vector3::UnitZ());
    break;
  case 6:
    input.SceneFault = SafetyFault::InvalidContact;
    break;
  case 7:
    input.Observed.State = DeviceState::Error;
    break;
  case 8:
    hand.Chain.Fail(SafetyFault::UntakenForce);
    break;
  case 9:
    hand.Chain.Fail(SafetyFault::SwitchedOff);
    break;
  default:
    break;
  }
  return hand.Apply(input);
}

TEST(FaultRecovery, NoForceBetweenAnyFaultAndRearmWithMotors)
{
  test::Random random(2301);
  std::uniform_int_distribution<int> chance(0, 99);
  int faults = 0;
  for (int session = 0; session < 300; ++session)
  {
    PushedHand hand(true);
    SafetyFault first = SafetyFault::None;
    for (int n = 0; n < 1000; ++n)
    {
      const bool isGood = chance(random) < 90;
      const double force = isGood ? hand.Tick() : TickWithAnyFault(hand, random);
      ASSERT_TRUE(first == SafetyFault::None || (force == 0.0 && hand.Fault() == first))
          << session << ' ' << n;
      first = hand.Fault();
    }
    faults += first != SafetyFault::None ? 1 : 0;
    hand.Chain.Rearm();
    EXPECT_EQ(hand.Tick(20), Push);
  }
  EXPECT_EQ(faults, 300);
}

TEST(FaultRecovery, ForceReturnsOnlyAfterFaultsOfTimingAndTheWait)
{
  test::Random random(2302);
  std::uniform_int_distribution<int> chance(0, 999);
  int resumed = 0;
  for (int session = 0; session < 60; ++session)
  {
    PushedHand hand(false);
    SafetyFault last = SafetyFault::None;
    std::int64_t off = 0; // ns, when forces went off
    for (int n = 0; n < 10'000; ++n)
    {
      const double force = chance(random) < 998 ? hand.Tick() : TickWithAnyFault(hand, random);
      const SafetyFault fault = hand.Fault();
      ASSERT_TRUE(fault == SafetyFault::None || force == 0.0) << session << ' ' << n;
      if (last == SafetyFault::None)
      {
        off = hand.Now;
      }
      else if (fault == SafetyFault::None)
      {
        ASSERT_TRUE(IsOfTiming(last)) << Describe(last);
        ASSERT_GT(hand.Now - off, FaultRecovery::Wait);
        ASSERT_EQ(force, 0.0);
        ++resumed;
      }
      if (!hand.Chain.Report().WillResume && chance(random) < 10)
      {
        hand.Chain.Rearm();
      }
      last = hand.Fault();
    }
  }
  EXPECT_GT(resumed, 50);
}
} // namespace
} // namespace palpate::fault_recovery_test
