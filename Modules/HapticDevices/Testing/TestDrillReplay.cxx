#include "DrillCases.h"
#include "RecordedSession.h"
#include "TemporaryFolder.h"
#include "TouchReplay.h"

namespace palpate::drill_replay_test
{
namespace
{
using test::DrilledBlock;

// A hand that descends on a block and moves to and fro in it.
SimulatedSettings Hand()
{
  SimulatedSettings device;
  device.Path = [](double time)
  {
    return Vector3(3.0 * std::sin(5.0 * time), 2.0 * std::sin(3.0 * time),
                   12.0 - std::min(20.0 * time, 6.0));
  };
  return device;
}

// Records drilling with strokes, undo and redo, and an editor that runs only now and then.
std::shared_ptr<TouchRecording> Drilled(DrilledBlock& block, const ServoSettings& settings)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder / "session.touch").string();
  TouchScene scene = block.Scene();
  scene.Structures[0].Drill.Drag = 0.01;
  scene.Structures[0].Drill.Vibration = 0.3;
  test::SimulatedTouch touch(scene, Hand(), settings);
  TouchRecorder recorder;
  EXPECT_TRUE(recorder.Start(path, test::SessionOf(touch.Device, settings)).IsOk());
  for (int n = 0; n < 3000; ++n)
  {
    touch.Loop.RunDrill(n % 700 > 100);
    if (n == 1450 || n == 2170)
    {
      touch.Loop.Command(DrillCommand::Undo);
    }
    if (n == 1480)
    {
      touch.Loop.Command(DrillCommand::Redo);
    }
    touch.Tick();
    if (n % 11 == 3 || n % 13 == 0)
    {
      block.Editor->Take();
    }
    EXPECT_TRUE(recorder.Drain(touch.Loop).IsOk());
  }
  block.Editor->Take();
  EXPECT_TRUE(recorder.Finish().IsOk());
  auto recording = std::make_shared<TouchRecording>();
  EXPECT_TRUE(ReadTouchRecording(path, *recording).IsOk());
  return recording;
}

TEST(DrillReplay, ReplaysForcesAndHolesBitForBit)
{
  for (const int interval : {1, 3})
  {
    ServoSettings settings;
    settings.ModelInterval = interval;
    DrilledBlock first;
    const auto recording = Drilled(first, settings);
    EXPECT_GT(recording->Ticks.back().DrillOrders, 300u);
    ASSERT_GT(first.Editor->RemovedVolumes()[0], 1.0);
    DrilledBlock second;
    const auto edit = [&second](const TouchState& tick) { second.Editor->Take(tick.DrillVersion); };
    TouchScene scene = second.Scene();
    scene.Structures[0].Drill.Drag = 0.01;
    scene.Structures[0].Drill.Vibration = 0.3;
    ReplayComparison comparison;
    const auto scenes = {std::make_shared<const TouchScene>(scene)};
    ASSERT_TRUE(ReplayTouch(recording, scenes, comparison, edit).IsOk());
    second.Editor->Take();
    EXPECT_EQ(comparison.DifferentTicks, 0u);
    EXPECT_EQ(comparison.FirstDifference, -1);
    EXPECT_EQ(second.State(), first.State());
  }
}
} // namespace
} // namespace palpate::drill_replay_test
