#include "Watchdog.h"

#include "SafetyCases.h"

#include <gtest/gtest.h>

namespace palpate::watchdog_test
{
namespace
{
// A watchdog that has seen healthy ticks 0 to 9, and tick 10 to be modified.
struct Watched
{
  Watched()
  {
    for (std::uint64_t n = 0; n < 10; ++n)
    {
      EXPECT_EQ(this->Dog.Check(test::HealthyTick(n)), SafetyFault::None);
    }
  }
  Watchdog Dog{WatchdogLimits()};
  TickObservation Next = test::HealthyTick(10);
};

TEST(Watchdog, FailureOrLeavingReadyIsAFaultAtOnce)
{
  for (const DeviceState state : {DeviceState::Error, DeviceState::Closed, DeviceState::Homing})
  {
    Watched watched;
    watched.Next.State = state;
    EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::DeviceFailed);
  }
  Watched watched;
  watched.Next.HasSample = false;
  EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::DeviceFailed);
}

TEST(Watchdog, OrientationThatIsNoneIsAFault)
{
  const double odd[][4] = {{0.0, 0.0, 0.0, 0.0},
                           {0.0, 0.0, 0.0, 1.01},
                           {test::NotANumber, 0.0, 0.0, 1.0},
                           {test::Infinite, 0.0, 0.0, 1.0}};
  for (const auto& parts : odd)
  {
    Watched watched;
    std::copy(std::begin(parts), std::end(parts), watched.Next.Sample.Orientation.begin());
    EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::NonFinitePosition);
  }
}

TEST(Watchdog, TurnFasterThanAnyWristIsAFault)
{
  const auto turnedBy = [](double angle)
  {
    Watched watched;
    watched.Next.Sample.Orientation = {std::sin(0.5 * angle), 0.0, 0.0, std::cos(0.5 * angle)};
    return watched.Dog.Check(watched.Next);
  };
  EXPECT_EQ(turnedBy(0.09), SafetyFault::None);
  EXPECT_EQ(turnedBy(0.11), SafetyFault::ImplausibleMotion);
  EXPECT_EQ(turnedBy(2.0 * EIGEN_PI), SafetyFault::None) << "the same orientation";
}

TEST(Watchdog, FailureBeforeReadyIsAFault)
{
  Watchdog dog{WatchdogLimits()};
  TickObservation tick = test::HealthyTick(0);
  tick.State = DeviceState::Error;
  EXPECT_EQ(dog.Check(tick), SafetyFault::DeviceFailed);
}

TEST(Watchdog, ResetAllowsHomingAgain)
{
  Watched watched;
  watched.Dog.Reset();
  watched.Next.State = DeviceState::Homing;
  EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::None);
}

TEST(Watchdog, NotYetReadyIsNoFault)
{
  Watchdog dog{WatchdogLimits()};
  TickObservation tick = test::HealthyTick(0, {test::NotANumber, 0.0, 0.0});
  for (const DeviceState state : {DeviceState::Closed, DeviceState::Opening, DeviceState::Homing})
  {
    tick.State = state;
    EXPECT_EQ(dog.Check(tick), SafetyFault::None);
  }
}

TEST(Watchdog, HomingJumpIsNoMotionFault)
{
  Watchdog dog{WatchdogLimits()};
  TickObservation homing = test::HealthyTick(0, {500.0, 0.0, 0.0});
  homing.State = DeviceState::Homing;
  EXPECT_EQ(dog.Check(homing), SafetyFault::None);
  EXPECT_EQ(dog.Check(test::HealthyTick(1)), SafetyFault::None);
}

TEST(Watchdog, LateTickIsAFault)
{
  Watched watched;
  watched.Next.Tick.Started += 9'500'000;
  watched.Next.Sample.Time = watched.Next.Tick.Started;
  EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::StalledTick);
}

TEST(Watchdog, AcceptsTheLongestGap)
{
  for (const std::int64_t beyond : {0, 1})
  {
    Watched watched;
    watched.Next.Tick.Started += WatchdogLimits().LongestGap - test::TickPeriod + beyond;
    watched.Next.Sample.Time = watched.Next.Tick.Started;
    EXPECT_EQ(watched.Dog.Check(watched.Next),
              beyond > 0 ? SafetyFault::StalledTick : SafetyFault::None);
  }
}

// Its samples are old too, and its device may have slept: it is still a single fault.
TEST(Watchdog, SuspensionIsASeparateFault)
{
  for (const std::int64_t passed : {test::TickPeriod, 3600 * 1000 * test::TickPeriod})
  {
    Watched watched;
    watched.Next.Tick.Started += passed - test::TickPeriod;
    watched.Next.Tick.BootTime = watched.Next.Tick.Started + 10'000'001;
    EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::Suspended) << passed;
  }
  Watched brief;
  brief.Next.Tick.BootTime = 10'000'000;
  EXPECT_EQ(brief.Dog.Check(brief.Next), SafetyFault::None);
}

TEST(Watchdog, GapTooLongOnlyWithSuspensionIsAStall)
{
  Watched watched;
  watched.Next.Tick.Started += 5'000'000;
  watched.Next.Sample.Time = watched.Next.Tick.Started;
  watched.Next.Tick.BootTime = 10'000'001;
  EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::StalledTick);
}

TEST(Watchdog, TimesDoNotOverflow)
{
  for (const std::int64_t boot : {INT64_MAX, INT64_MAX / 2})
  {
    Watched watched;
    watched.Next.Tick.Started = INT64_MIN / 2;
    watched.Next.Tick.BootTime = boot;
    EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::Suspended);
  }
}

TEST(Watchdog, NonIncreasingTickTimeIsAFault)
{
  for (const std::int64_t back : {test::TickPeriod, 3600 * 1000 * test::TickPeriod})
  {
    Watched watched;
    watched.Next.Tick.Started -= back; // no time passes; an hour back
    watched.Next.Sample.Time = watched.Next.Tick.Started;
    EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::StalledTick) << back;
  }
}

TEST(Watchdog, SecondTickWithoutNewSampleIsAFault)
{
  Watched watched;
  watched.Next.Sample.Sequence = 10;
  EXPECT_EQ(watched.Dog.Check(watched.Next), SafetyFault::None);
  TickObservation second = test::HealthyTick(11);
  second.Sample.Sequence = 10;
  EXPECT_EQ(watched.Dog.Check(second), SafetyFault::StaleSample);
}

TEST(Watchdog, OldSampleIsAFaultEvenIfNew)
{
  Watched old;
  old.Next.Sample.Time -= 10'000'000;
  EXPECT_EQ(old.Dog.Check(old.Next), SafetyFault::None);
  Watched older;
  older.Next.Sample.Time -= 10'000'001;
  EXPECT_EQ(older.Dog.Check(older.Next), SafetyFault::StaleSample);
}

TEST(Watchdog, FutureSampleIsAFault)
{
  Watched near;
  near.Next.Sample.Time += 10'000'000;
  EXPECT_EQ(near.Dog.Check(near.Next), SafetyFault::None);
  Watched far;
  far.Next.Sample.Time += 10'000'001;
  EXPECT_EQ(far.Dog.Check(far.Next), SafetyFault::StaleSample);
}

TEST(Watchdog, ImplausiblyFastMotionIsAFault)
{
  Watched slow;
  slow.Next.Sample.Position = Vector3(4.99, 0.0, 0.0);
  EXPECT_EQ(slow.Dog.Check(slow.Next), SafetyFault::None);
  Watched fast;
  fast.Next.Sample.Position = Vector3(5.01, 0.0, 0.0);
  EXPECT_EQ(fast.Dog.Check(fast.Next), SafetyFault::ImplausibleMotion);
}

TEST(Watchdog, SamplesOfEqualTimeMayDifferByAFewCounts)
{
  for (const double moved : {0.49, 0.51}) // mm; 5 m/s for 0.1 ms are 0.5 mm
  {
    Watched watched;
    watched.Next.Sample.Time = test::HealthyTick(9).Sample.Time;
    watched.Next.Sample.Position = Vector3(0.0, moved, 0.0);
    EXPECT_EQ(watched.Dog.Check(watched.Next),
              moved < 0.5 ? SafetyFault::None : SafetyFault::ImplausibleMotion);
  }
}

TEST(Watchdog, NonFiniteSampleIsAFault)
{
  for (const double bad : {test::NotANumber, test::Infinite})
  {
    Watched position;
    position.Next.Sample.Position.Z = bad;
    EXPECT_EQ(position.Dog.Check(position.Next), SafetyFault::NonFinitePosition);
    Watched orientation;
    orientation.Next.Sample.Orientation[2] = bad;
    EXPECT_EQ(orientation.Dog.Check(orientation.Next), SafetyFault::NonFinitePosition);
  }
}

TEST(Watchdog, ResetForgetsEarlierTicks)
{
  Watched watched;
  watched.Dog.Reset();
  EXPECT_EQ(watched.Dog.Check(test::HealthyTick(5000, {90.0, 0.0, 0.0})), SafetyFault::None);
}
} // namespace
} // namespace palpate::watchdog_test
