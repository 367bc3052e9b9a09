// Clocks that jump forward, back, or stop: the servo's own, and the device's of its samples.
#include "ServoRun.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <string>

namespace palpate::clock_extremes_test
{
namespace
{
constexpr std::int64_t Second = 1'000'000'000; // ns
constexpr double Depth = 2.0;                  // mm
constexpr double Stiffness = 1.0;              // N/mm

// A hand at rest in a wall at 0, whose clocks a test may shift.
class PressedWall
{
public:
  PressedWall() : Run(test::WallScene(0.0, {Stiffness, 0.0}))
  {
    for (int n = 0; n < 600; ++n)
    {
      this->Tick(-Depth);
    }
  }

  const TouchState& Tick(double height)
  {
    TickObservation now = test::HealthyTick(this->Ticks++, {0.0, 0.0, height});
    now.Tick.Started = this->IsStopped ? this->Stopped : now.Tick.Started + this->ClockShift;
    now.Tick.Scheduled = now.Tick.Started;
    this->Stopped = now.Tick.Started;
    this->Run.Device.Next.Position = now.Sample.Position;
    this->Run.Device.Next.Time = now.Tick.Started + this->SampleShift;
    this->Run.Loop.Tick(now.Tick);
    return this->Run.Loop.Latest();
  }
  double Force() const { return this->Run.Device.Applied[2]; }

  test::ServoRun Run;
  std::int64_t ClockShift = 0;  // ns, of ticks and samples
  std::int64_t SampleShift = 0; // ns, of samples only
  bool IsStopped = false;       // every tick starts at the time of the last one

private:
  std::uint64_t Ticks = 0;
  std::int64_t Stopped = 0;
};

TEST(ClockExtremes, WallIsPressedInitially)
{
  EXPECT_NEAR(PressedWall().Force(), Stiffness * Depth, 1e-12);
}

struct ClockCase
{
  std::string Name;
  std::function<void(PressedWall&)> Break;
};

void PrintTo(const ClockCase& c, std::ostream* stream)
{
  *stream << c.Name;
}

const ClockCase ServoClocks[] = {
    {"ForwardABit", [](PressedWall& wall) { wall.ClockShift = 11'000'000; }},
    {"ForwardAnHour", [](PressedWall& wall) { wall.ClockShift = 3600 * Second; }},
    {"ForwardACentury", [](PressedWall& wall) { wall.ClockShift = 3'000'000'000 * Second; }},
    {"BackATick", [](PressedWall& wall) { wall.ClockShift = -2'000'000; }},
    {"BackAnHour", [](PressedWall& wall) { wall.ClockShift = -3600 * Second; }},
    {"StandsStill", [](PressedWall& wall) { wall.IsStopped = true; }}};

class ServoClockExtremes : public ::testing::TestWithParam<ClockCase>
{
};

// It is unknown how long the force was held, or will be.
TEST_P(ServoClockExtremes, SwitchForcesOffUntilRearmed)
{
  PressedWall wall;
  GetParam().Break(wall);
  for (int n = 0; n < 50; ++n)
  {
    const TouchState& state = wall.Tick(-Depth);
    ASSERT_EQ(state.Safety.Fault, SafetyFault::StalledTick) << n;
    ASSERT_EQ(wall.Force(), 0.0) << n;
  }
  wall.IsStopped = false;
  wall.Run.Loop.Rearm();
  for (int n = 0; n < 600; ++n)
  {
    ASSERT_EQ(wall.Tick(-Depth).Safety.Fault, SafetyFault::None) << n;
    ASSERT_LE(wall.Force(), Stiffness * Depth + 1e-12) << n;
  }
  EXPECT_NEAR(wall.Force(), Stiffness * Depth, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Each, ServoClockExtremes, ::testing::ValuesIn(ServoClocks),
                         [](const auto& each) { return each.param.Name; });

TEST(ClockExtremes, OldSamplesSwitchForcesOff)
{
  for (const std::int64_t age : {11'000'000L, 3600 * Second})
  {
    PressedWall wall;
    wall.SampleShift = -age;
    EXPECT_EQ(wall.Tick(-Depth).Safety.Fault, SafetyFault::StaleSample) << age;
    EXPECT_EQ(wall.Force(), 0.0);
  }
}

// A time in the future is never old, and would allow any motion since the last one.
TEST(ClockExtremes, FutureSamplesSwitchForcesOff)
{
  for (const std::int64_t ahead : {11'000'000L, 3600 * Second})
  {
    PressedWall wall;
    wall.SampleShift = ahead;
    EXPECT_EQ(wall.Tick(-Depth).Safety.Fault, SafetyFault::StaleSample) << ahead;
    EXPECT_EQ(wall.Force(), 0.0);
  }
}

// A device may read the clock slightly later than the servo.
TEST(ClockExtremes, AcceptsSlightlyOldOrFutureSamples)
{
  for (const std::int64_t shift : {-5'000'000L, -1'000'000L, 1'000'000L})
  {
    PressedWall wall;
    wall.SampleShift = shift;
    for (int n = 0; n < 100; ++n)
    {
      ASSERT_EQ(wall.Tick(-Depth).Safety.Fault, SafetyFault::None) << shift;
      ASSERT_NEAR(wall.Force(), Stiffness * Depth, 1e-12) << shift;
    }
  }
}
} // namespace
} // namespace palpate::clock_extremes_test
