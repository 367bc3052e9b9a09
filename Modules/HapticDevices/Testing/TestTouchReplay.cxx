#include "TouchReplay.h"

#include "OpenBuiltInDevice.h"
#include "RecordedSession.h"
#include "ReplayDevice.h"
#include "TemporaryFolder.h"

namespace palpate::touch_replay_test
{
namespace
{
std::shared_ptr<TouchRecording> Recorded(int ticks, const ServoSettings& settings = ServoSettings())
{
  const test::TemporaryFolder folder;
  const std::string path = (folder / "session.touch").string();
  test::RecordSession(path, ticks, settings);
  auto recording = std::make_shared<TouchRecording>();
  const Status status = ReadTouchRecording(path, *recording);
  EXPECT_TRUE(status.IsOk()) << status.Message();
  return recording;
}

TEST(TouchReplay, ReplaysSessionBitForBit)
{
  for (const int interval : {1, 3})
  {
    ServoSettings settings;
    settings.ModelInterval = interval;
    const auto recording = Recorded(4000, settings);
    double strongest = 0.0;
    for (const TouchState& tick : recording->Ticks)
    {
      strongest = std::max(strongest, Vector3(tick.ForceDevice).norm());
    }
    EXPECT_GT(strongest, 1.0);
    ReplayComparison comparison;
    ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), comparison).IsOk());
    EXPECT_EQ(comparison.Ticks, 4000u);
    EXPECT_EQ(comparison.DifferentTicks, 0u);
    EXPECT_EQ(comparison.FirstDifference, -1);
    EXPECT_EQ(comparison.LargestDifference, 0.0);
  }
}

TEST(TouchReplay, ReplaysDeviceFailure)
{
  const test::TemporaryFolder folder;
  for (const SimulatedFault fault : {SimulatedFault::Unplugged, SimulatedFault::RefusedForce})
  {
    SimulatedSettings device;
    device.Path = test::PressingPath(3.0, 2.0);
    test::SimulatedTouch touch(*test::RecordedScenes()[0], device);
    auto recording = std::make_shared<TouchRecording>();
    recording->Session = test::SessionOf(touch.Device, ServoSettings());
    for (int n = 0; n < 400; ++n)
    {
      touch.Device.Inject(n < 300 ? SimulatedFault::None : fault);
      recording->Ticks.push_back(touch.Tick());
    }
    ASSERT_NE(recording->Ticks.back().Safety.Fault, SafetyFault::None);
    ReplayComparison comparison;
    ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), comparison).IsOk());
    EXPECT_EQ(comparison.DifferentTicks, 0u);
  }
}

TEST(TouchReplay, ReplaysSwitchingForces)
{
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, 2.0);
  test::SimulatedTouch touch(*test::RecordedScenes()[0], device);
  auto recording = std::make_shared<TouchRecording>();
  recording->Session = test::SessionOf(touch.Device, ServoSettings());
  for (int n = 0; n < 900; ++n)
  {
    if (n == 500 || n == 700)
    {
      touch.Loop.Rearm();
    }
    if (n == 400 || n == 500)
    {
      touch.Loop.SwitchOff(); // the second time together with being switched on
    }
    recording->Ticks.push_back(touch.Tick());
    const bool isOff = n >= 400 && n < 700;
    ASSERT_EQ(touch.Loop.Latest().Safety.Fault,
              isOff ? SafetyFault::SwitchedOff : SafetyFault::None);
  }
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0u);
}

TEST(TouchReplay, ReplaysSuspensionFault)
{
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, 2.0);
  test::SimulatedTouch touch(*test::RecordedScenes()[0], device);
  auto recording = std::make_shared<TouchRecording>();
  recording->Session = test::SessionOf(touch.Device, ServoSettings());
  for (int n = 0; n < 900; ++n)
  {
    if (n == 400)
    {
      touch.Time.Suspend(3'600'000'000'000);
    }
    if (n == 500)
    {
      touch.Loop.Rearm();
    }
    recording->Ticks.push_back(touch.Tick());
    ASSERT_EQ(recording->Ticks.back().Safety.Fault,
              n >= 400 && n < 500 ? SafetyFault::Suspended : SafetyFault::None);
  }
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0u);
}

// Held up at 300, again during the wait at 400, and at 1500; stopped by a person during that wait.
TEST(TouchReplay, ReplaysForcesThatReturnByThemselves)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder / "session.touch").string();
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, 2.0);
  test::SimulatedTouch touch(*test::RecordedScenes()[0], device);
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(path, test::SessionOf(touch.Device, ServoSettings())).IsOk());
  for (int n = 0; n < 3000; ++n)
  {
    if (n == 300 || n == 400 || n == 1500)
    {
      touch.Time.Advance(15'000'000);
    }
    if (n == 1600)
    {
      touch.Loop.SwitchOff();
    }
    if (n == 2500)
    {
      touch.Loop.Rearm();
    }
    const SafetyReport report = touch.Tick().Safety;
    ASSERT_TRUE(recorder.Take(touch.Loop.Latest()).IsOk());
    const bool isWaiting = (n >= 300 && n <= 650) || (n >= 1500 && n < 1600);
    ASSERT_EQ(report.WillResume, isWaiting) << n;
    ASSERT_EQ(report.IsArmed, !isWaiting && !(n >= 1600 && n < 2500)) << n;
  }
  ASSERT_TRUE(recorder.Finish().IsOk());
  auto recording = std::make_shared<TouchRecording>();
  ASSERT_TRUE(ReadTouchRecording(path, *recording).IsOk());
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), comparison).IsOk());
  EXPECT_EQ(comparison.Ticks, 3000u);
  EXPECT_EQ(comparison.DifferentTicks, 0u);
  recording->Session.Device.HasMotors = true;
  ReplayComparison different;
  ASSERT_TRUE(ReplayTouch(recording, test::RecordedScenes(), different).IsOk());
  EXPECT_GT(different.DifferentTicks, 100u);
}

TEST(TouchReplay, ReplaysDrillingByDeviceButton)
{
  test::ScriptedDevice device;
  ServoSettings settings;
  settings.PedalButtons = 1;
  Servo servo(device, settings);
  const auto scene = test::RecordedScenes()[0];
  ASSERT_TRUE(servo.Publish(scene).IsOk());
  auto recording = std::make_shared<TouchRecording>();
  recording->Session = test::SessionOf(device, settings);
  int drilling = 0;
  LoopSchedule schedule(0, 1'000'000);
  for (int n = 0; n < 900; ++n)
  {
    const TickInfo tick = schedule.Begin(schedule.Deadline());
    device.Next.Time = tick.Started;
    device.Next.Buttons = n / 100 % 2 == 0 ? 1 : 0;
    if (n == 250)
    {
      servo.SwitchOff();
    }
    if (n == 350)
    {
      servo.Rearm();
    }
    servo.Tick(tick);
    recording->Ticks.push_back(servo.Latest());
    drilling += servo.Latest().IsDrilling ? 1 : 0;
  }
  // Not at first, while it is held from the start, and up to the fault in the third hundred.
  EXPECT_EQ(drilling, 51 + 300);
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, {scene}, comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0u);
}

TEST(TouchReplay, ScenesThatWereContinuedAreSoAgain)
{
  std::vector<std::shared_ptr<const TouchScene>> scenes;
  for (const double height : {0.0, 0.7, -0.4, 0.2})
  {
    auto scene = std::make_shared<TouchScene>(test::WallScene(height, {0.8, 0.0005}));
    scene->Structures[0].Id = 1;
    scenes.push_back(std::move(scene));
  }
  SimulatedSettings device;
  device.Path = test::PressingPath(3.0, 2.0);
  test::SimulatedTouch touch(*scenes[0], device);
  auto recording = std::make_shared<TouchRecording>();
  recording->Session = test::SessionOf(touch.Device, ServoSettings());
  int continued = 0;
  for (int n = 0; n < 2000; ++n)
  {
    if (n % 500 == 250 && n < 1500)
    {
      const SceneEntry entry = n == 750 ? SceneEntry::FadeIn : SceneEntry::Continuing;
      ASSERT_TRUE(touch.Loop.Publish(scenes[static_cast<std::size_t>(n) / 500 + 1], entry).IsOk());
    }
    recording->Ticks.push_back(touch.Tick());
    continued += recording->Ticks.back().WasContinued ? 1 : 0;
  }
  EXPECT_EQ(continued, 2);
  const test::TemporaryFolder folder;
  const std::string path = (folder / "session.touch").string();
  TouchRecorder recorder;
  ASSERT_TRUE(recorder.Start(path, recording->Session).IsOk());
  for (const TouchState& tick : recording->Ticks)
  {
    ASSERT_TRUE(recorder.Take(tick).IsOk());
  }
  ASSERT_TRUE(recorder.Finish().IsOk());
  ASSERT_TRUE(ReadTouchRecording(path, *recording).IsOk());
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, scenes, comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0u);
  auto again = std::make_shared<TouchRecording>(*recording);
  for (TouchState& tick : again->Ticks)
  {
    tick.WasContinued = false;
  }
  ReplayComparison different;
  ASSERT_TRUE(ReplayTouch(again, scenes, different).IsOk());
  EXPECT_GT(different.DifferentTicks, 100u);
}

TEST(TouchReplay, DetectsForceChanges)
{
  const auto recording = Recorded(4000);
  auto scenes = test::RecordedScenes();
  TouchScene stiffer = *scenes[0];
  stiffer.Structures[0].Law.Stiffness *= 1.1;
  scenes[0] = std::make_shared<TouchScene>(stiffer);
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, scenes, comparison).IsOk());
  EXPECT_GT(comparison.DifferentTicks, 500u);
  EXPECT_GT(comparison.FirstDifference, 0);
  EXPECT_GT(comparison.LargestDifference, 0.05);
}

TEST(TouchReplay, RejectsMissingScene)
{
  ReplayComparison comparison;
  EXPECT_FALSE(ReplayTouch(Recorded(400), {test::RecordedScenes()[0]}, comparison).IsOk());
  EXPECT_FALSE(ReplayTouch(std::make_shared<TouchRecording>(), {}, comparison).IsOk());
}

TEST(ReplayDevice, PlaysSessionAndEnds)
{
  const auto recording = Recorded(400);
  ManualClock clock(123'456'789);
  ReplayDevice device(clock, recording);
  EXPECT_EQ(device.State(), DeviceState::Closed);
  ASSERT_TRUE(device.Open().IsOk());
  DeviceSample sample;
  for (int n = 0; n < 100; ++n)
  {
    ASSERT_TRUE(device.Read(sample));
    EXPECT_EQ(sample.Time, clock.Now());
    EXPECT_EQ(sample.Position.X, recording->Ticks[n].Sample.Position.X);
    EXPECT_TRUE(device.Apply(Vector3::UnitX()));
    clock.Advance(1'000'000);
  }
  EXPECT_TRUE(device.Problem().empty());
  clock.Advance(10'000'000'000);
  EXPECT_FALSE(device.Read(sample));
  EXPECT_EQ(device.State(), DeviceState::Error);
  EXPECT_FALSE(device.Problem().empty());
}

TEST(ReplayDevice, IsCreatedByName)
{
  const test::TemporaryFolder folder;
  const std::string path = (folder / "a:b.touch").string();
  test::RecordSession(path, 40);
  DeviceRegistry registry;
  ASSERT_TRUE(RegisterBuiltInDevices(registry).IsOk());
  ManualClock clock;
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(registry.Make("replay:" + path, clock, device).IsOk());
  EXPECT_EQ(device->Capabilities().MaximumForce, 8.0);
  EXPECT_FALSE(registry.Make("replay:nowhere", clock, device).IsOk());
}
} // namespace
} // namespace palpate::touch_replay_test
