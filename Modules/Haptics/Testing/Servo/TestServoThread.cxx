#include "ServoThread.h"

#include "EmergencyStop.h"
#include "ManualClock.h"
#include "SlowModel.h"
#include "TimedDevice.h"
#include "TouchDoubles.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <thread>
#include <vector>

namespace palpate::servo_thread_test
{
namespace
{
using test::TimedDevice;

// These loops run at full speed: with real-time priority nothing else would run.
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

TEST(ServoThread, AdoptsScenesWhileRunningAndEndsWithoutForce)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoThread servo(device, clock, ServoSettings());
  ASSERT_TRUE(servo.Start(Ordinary()).IsOk());
  EXPECT_TRUE(servo.IsRunning());
  EXPECT_FALSE(servo.Start(Ordinary()).IsOk());
  for (int n = 1; n <= 50; ++n)
  {
    const auto scene = std::make_shared<const TouchScene>(test::WallScene(0.0, {0.1 * n, 0.0}));
    ASSERT_TRUE(servo.Loop().Publish(scene).IsOk());
    while (servo.Loop().Latest().Structure < 0)
    {
      std::this_thread::yield();
    }
  }
  // The last scene is adopted and faded in.
  while (servo.Loop().Latest().ForceDevice.Z < 5.0 - 1e-9)
  {
    std::this_thread::yield();
  }
  servo.Stop();
  EXPECT_FALSE(servo.IsRunning());
  EXPECT_EQ(device.Applied, Vector3::Zero());
  EXPECT_EQ(servo.Loop().Latest().Safety.Fault, SafetyFault::None);
}

TEST(ServoThread, KeepsItsRateAndCountsIt)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoSettings settings;
  settings.Rate = 500.0;
  ServoThread servo(device, clock, settings);
  ASSERT_TRUE(servo.Start(Ordinary()).IsOk());
  while (servo.Statistics().Periods.Count() < 200)
  {
    std::this_thread::yield();
  }
  servo.Stop();
  EXPECT_EQ(servo.Statistics().Periods.Min(), 2'000'000);
  EXPECT_EQ(servo.Statistics().Periods.Max(), 2'000'000);
  EXPECT_EQ(servo.Statistics().Periods.Misses(), 0u);
}

TEST(ServoThread, CountsSkippedPeriodsAndLateTicks)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoThread servo(device, clock, ServoSettings());
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  const auto cost = std::make_shared<std::atomic<std::int64_t>>(2'500'000);
  scene.Structures[0].Model =
      std::make_shared<test::SlowModel>(scene.Structures[0].Model, clock, cost);
  ASSERT_TRUE(servo.Loop().Publish(std::make_shared<TouchScene>(scene)).IsOk());
  ASSERT_TRUE(servo.Start(Ordinary()).IsOk());
  while (servo.Statistics().Periods.Count() < 200)
  {
    std::this_thread::yield();
  }
  servo.Stop();
  const ServoStatistics& counted = servo.Statistics();
  const std::uint64_t ticks = counted.Periods.Count();
  // The first tick queries the model twice, each other one once: 2.5 periods.
  EXPECT_EQ(counted.Periods.Min(), 2'500'000);
  EXPECT_EQ(counted.Periods.Max(), 5'000'000);
  EXPECT_EQ(counted.Periods.Misses() + ticks, 5 * (ticks + 1) / 2);
  EXPECT_EQ(counted.Durations.Count(), ticks + 1);
  EXPECT_EQ(counted.Durations.Min(), 2'500'000);
  EXPECT_EQ(counted.Durations.Misses(), ticks);
}

// Starts it, and stops it after at least some hundred ticks. Returns the first of them; the ring
// keeps those from the start.
std::vector<TouchState> FirstTicks(ServoThread& servo)
{
  constexpr std::uint64_t Enough = 400;
  for (TouchState old; servo.Loop().PopRecorded(old);)
  {
  }
  EXPECT_TRUE(servo.Start(Ordinary()).IsOk());
  while (servo.Statistics().Periods.Count() < Enough)
  {
    std::this_thread::yield();
  }
  servo.Stop();
  std::vector<TouchState> ticks(Enough);
  for (TouchState& tick : ticks)
  {
    EXPECT_TRUE(servo.Loop().PopRecorded(tick));
  }
  return ticks;
}

TEST(ServoThread, FadesInWithoutAFaultAfterAPauseOfAnyLength)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoThread servo(device, clock, ServoSettings());
  const auto scene = std::make_shared<const TouchScene>(test::WallScene(0.0, {1.0, 0.0}));
  ASSERT_TRUE(servo.Loop().Publish(scene).IsOk());
  for (int n = 0; n < 3; ++n)
  {
    const std::vector<TouchState> ticks = FirstTicks(servo);
    // Counted since Start: the first tick has no period before it.
    EXPECT_EQ(servo.Statistics().Durations.Count(), servo.Statistics().Periods.Count() + 1);
    EXPECT_EQ(Vector3(ticks[0].ForceDevice), Vector3::Zero()) << n;
    for (const TouchState& tick : ticks)
    {
      ASSERT_EQ(tick.Safety.Fault, SafetyFault::None) << n << ": " << Describe(tick.Safety.Fault);
      // N; the ramp to 1 N takes 300 ticks
      const double most = std::min(1.0, static_cast<double>(tick.Tick.Number) / 300.0);
      ASSERT_NEAR(tick.ForceDevice.Z, most, 1e-9) << n << ": " << tick.Tick.Number;
    }
    clock.Advance(3'600'000'000'000);
    clock.Suspend(3'600'000'000'000);
  }
}

TEST(ServoThread, PauseKeepsFaultsAndReleasesThePedal)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoThread servo(device, clock, ServoSettings());
  servo.Loop().SwitchOff();
  FirstTicks(servo);
  servo.Loop().RunDrill(true);
  for (const TouchState& tick : FirstTicks(servo))
  {
    ASSERT_EQ(tick.Safety.Fault, SafetyFault::SwitchedOff);
    ASSERT_FALSE(tick.IsDrilling);
  }
}

TEST(ServoThread, EmergencyStopKeepsForcesOffUntilRearmed)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoThread servo(device, clock, ServoSettings());
  EmergencyStop::Order();
  const std::vector<TouchState> first = FirstTicks(servo);
  servo.Loop().Rearm();
  const std::vector<TouchState> rearmed = FirstTicks(servo);
  EmergencyStop::Forget();
  const std::vector<TouchState> later = FirstTicks(servo);
  EXPECT_TRUE(rearmed[0].WasRearmed);
  for (const auto& ticks : {first, rearmed, later})
  {
    for (const TouchState& tick : ticks)
    {
      ASSERT_EQ(tick.Safety.Fault, SafetyFault::SwitchedOff) << tick.Tick.Number;
    }
  }
  servo.Loop().Rearm();
  EXPECT_EQ(FirstTicks(servo)[0].Safety.Fault, SafetyFault::None);
}

TEST(ServoThread, RejectsInvalidRate)
{
  ManualClock clock;
  TimedDevice device(clock);
  ServoSettings settings;
  for (const double rate : {0.0, -1.0, 1e9, std::numeric_limits<double>::quiet_NaN()})
  {
    settings.Rate = rate;
    ServoThread servo(device, clock, settings);
    EXPECT_FALSE(servo.Start(Ordinary()).IsOk()) << rate;
  }
}
} // namespace
} // namespace palpate::servo_thread_test
