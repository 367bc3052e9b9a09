#include "ServoRun.h"
#include "ServoThread.h"
#include "SlowModel.h"
#include "TimedDevice.h"

#include <gtest/gtest.h>

#include <array>
#include <thread>
#include <vector>

namespace palpate
{
namespace
{
// Two walls of one structure, the coarser one higher, at 0.5 N/mm.
TouchScene SceneWithStandIns(int count)
{
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  for (int n = 1; n <= count; ++n)
  {
    scene.Structures[0].Coarser.push_back(
        {std::make_shared<test::WallModel>(0.4 * n), {}, "rougher"});
  }
  return scene;
}

class LevelRun
{
public:
  explicit LevelRun(const TouchScene& scene) : Loop(this->Device, ServoSettings())
  {
    EXPECT_TRUE(this->Loop.Publish(std::make_shared<TouchScene>(scene)).IsOk());
  }
  double TickAt(double z, int level)
  {
    const TickObservation healthy = test::HealthyTick(this->Ticks++, {0.0, 0.0, z});
    this->Device.Next.Position = healthy.Sample.Position;
    this->Device.Next.Time = healthy.Sample.Time;
    this->Loop.Tick(healthy.Tick, level);
    return this->Device.Applied[2];
  }
  double RestAt(double z, int level)
  {
    for (int n = 0; n < 600; ++n)
    {
      this->TickAt(z, level);
    }
    return this->Device.Applied[2];
  }

private:
  std::uint64_t Ticks = 0;

public:
  test::ScriptedDevice Device;
  Servo Loop;
};

TEST(ServoLevels, AStandInIsFeltWithoutAStepAndTheModelAgain)
{
  LevelRun run(SceneWithStandIns(2));
  double last = run.RestAt(-1.0, 0);
  ASSERT_NEAR(last, 0.5, 1e-12);
  for (const int level : {1, 2, 0})
  {
    for (int n = 0; n < 200; ++n)
    {
      const double force = run.TickAt(-1.0, level);
      // 0.4 N from rung to rung but one, over a hundred ticks.
      ASSERT_LE(std::abs(force - last), 0.4 / 100.0 + 1e-12);
      ASSERT_EQ(run.Loop.Latest().Level, level);
      ASSERT_FALSE(run.Loop.Latest().Safety.IsRamping);
      last = force;
    }
    EXPECT_NEAR(last, 0.5 + 0.2 * level, 1e-12);
  }
}

TEST(ServoLevels, WhatIsMetAtALevelIsMetByItsStandInAtOnce)
{
  LevelRun run(SceneWithStandIns(1));
  run.RestAt(2.0, 0);
  EXPECT_EQ(run.RestAt(0.5, 1), 0.0);
  EXPECT_NEAR(run.TickAt(0.3, 1), 0.05, 1e-12);
}

TEST(ServoLevels, ALevelBeyondTheCoarsestIsTheCoarsest)
{
  LevelRun run(SceneWithStandIns(1));
  EXPECT_NEAR(run.RestAt(-1.0, 7), 0.7, 1e-12);
  EXPECT_EQ(run.Loop.Latest().Level, 1);
  LevelRun plain(SceneWithStandIns(0));
  EXPECT_NEAR(plain.RestAt(-1.0, 7), 0.5, 1e-12);
  EXPECT_EQ(plain.Loop.Latest().Level, 0);
}

TEST(ServoLevels, AStandInThatCannotBeFeltIsRefused)
{
  TouchScene scene = SceneWithStandIns(1);
  scene.Structures[0].Coarser[0].Tool = ToolShape::Capsule(1.0, 2.0, 50);
  test::ScriptedDevice device;
  Servo loop(device, ServoSettings());
  EXPECT_FALSE(loop.Publish(std::make_shared<TouchScene>(scene)).IsOk());
  scene.Structures[0].Coarser[0] = {};
  EXPECT_EQ(loop.Publish(std::make_shared<TouchScene>(scene)).Message(),
            "A stand-in for the structure wall has no model to be touched.");
}

TEST(ServoLevels, ALoopThatRunsOutOfTimeKeepsItsRateByAStandInAndComesBack)
{
  ManualClock clock;
  const auto cost = std::make_shared<std::atomic<std::int64_t>>(100'000);
  const auto quick = std::make_shared<std::atomic<std::int64_t>>(100'000);
  TouchScene scene = test::WallScene(0.0, {0.5, 0.0});
  scene.Structures[0].Model =
      std::make_shared<test::SlowModel>(std::make_shared<test::WallModel>(0.0), clock, cost);
  scene.Structures[0].Coarser.push_back(
      {std::make_shared<test::SlowModel>(std::make_shared<test::WallModel>(0.4), clock, quick),
       {},
       "rougher"});
  test::TimedDevice device(clock);
  ServoSettings settings;
  settings.RecordedTicks = 100'000;
  ServoThread servo(device, clock, settings);
  ASSERT_TRUE(servo.Loop().Publish(std::make_shared<TouchScene>(scene)).IsOk());
  RealtimeRequest ordinary;
  ordinary.Priority = 0; // else nothing else would run
  ASSERT_TRUE(servo.Start(ordinary).IsOk());
  // So many ticks at least, and no more than there is room for.
  const auto waitFor = [&](int level, std::uint64_t ticks)
  {
    const std::uint64_t from = servo.Loop().Latest().Tick.Number;
    std::uint64_t now = from;
    while ((servo.Loop().Latest().Level != level || now < from + ticks) && now < from + 20'000)
    {
      std::this_thread::yield();
      now = servo.Loop().Latest().Tick.Number;
    }
    EXPECT_EQ(servo.Loop().Latest().Level, level);
  };
  waitFor(0, 1000);
  *cost = 1'700'000; // ns: more than the period
  waitFor(1, 500);
  *cost = 100'000;
  waitFor(0, 3000);
  servo.Stop();
  std::vector<TouchState> ticks;
  for (TouchState state; servo.Loop().PopRecorded(state);)
  {
    ticks.push_back(state);
  }
  ASSERT_EQ(servo.Loop().LostTicks(), 0U);
  int raised = 0;
  std::array<std::uint64_t, 2> skipped{};
  for (std::size_t n = 400; n + 1 < ticks.size(); ++n)
  {
    const TouchState& one = ticks[n + 1];
    raised += one.Level > ticks[n].Level ? 1 : 0;
    // Two ticks may be too long before the level rises, and what they skipped is seen afterwards.
    const bool isSettled = one.Level == 1 && ticks[n].Level == 1;
    skipped[isSettled ? 1 : 0] += one.Tick.SkippedPeriods;
    const double step = Vector3(one.ForceDevice)[2] - Vector3(ticks[n].ForceDevice)[2];
    ASSERT_LE(std::abs(step),
              0.2 / 100.0 * (1 + static_cast<double>(one.Tick.SkippedPeriods)) + 1e-3);
    ASSERT_EQ(one.Safety.Fault, SafetyFault::None);
  }
  EXPECT_EQ(skipped[1], 0U);
  EXPECT_GE(raised, 1);
  // The first try to come back may have come while the model was slow still: two ticks each.
  EXPECT_LE(skipped[0], 4U * static_cast<unsigned>(raised));
}
} // namespace
} // namespace palpate
