#include "StudyTouch.h"

#include "Interruption.h"
#include "ManualClock.h"
#include "OpenBuiltInDevice.h"
#include "PacedClock.h"
#include "PlacedDevice.h"
#include "SafetyText.h"
#include "SimulatedDevice.h"
#include "StudyPhantoms.h"
#include "TouchReplay.h"

#include <cstdio>
#include <cstdlib>
#include <gtest/gtest.h>
#include <thread>

namespace palpate::study_touch_test
{
namespace
{
// These servos run as fast as they can, in virtual time; with real-time priority they would block
// everything else.
RealtimeRequest Ordinary()
{
  RealtimeRequest request;
  request.Priority = 0;
  return request;
}

SceneContact Sphere(int label, double radius)
{
  const RadialModel model(0, {radius * std::sqrt(4.0 * M_PI)}, Vector3::Zero());
  return {label, std::make_shared<const TouchContact>(
                     MakeModelContact(model, RadialContactMode::Nearest, "ball"))};
}

StudyState SphereState(int label)
{
  StudyState state;
  state.Structures = {test::StudyPhantom::Structure(label, TouchRepresentation::Harmonics)};
  state.Tool.Radius = 0.0;
  return state;
}

constexpr double Radius = 20.0;

class StudyTouchTest : public testing::Test
{
protected:
  std::unique_ptr<HapticDevice> OpenDevice(Clock& clock)
  {
    std::unique_ptr<HapticDevice> device;
    EXPECT_TRUE(OpenBuiltInDevice("simulated", clock, device).IsOk());
    return device;
  }
  void Start()
  {
    const Status status =
        this->Touch.Start(this->OpenDevice(this->Time), this->State, this->Contacts);
    ASSERT_TRUE(status.IsOk()) << status.Message();
  }
  // Presses to a depth below the sphere's surface along x, from outside.
  void Press(double depth)
  {
    this->Touch.MoveHand(Vector3(Radius + 5.0, 0.0, 0.0));
    this->WaitUntil([](const StudyTouchReading& now)
                    { return now.Newest.ProbeWorld.X > Radius + 4.0; });
    this->Touch.MoveHand(Vector3(Radius - depth, 0.0, 0.0));
  }
  // The same with a placed device in a scene of scale 1, whose hand starts outside.
  void Press(test::PlacedDevice& device, double depth)
  {
    for (double x = Radius + 1.0; x >= Radius - depth; x -= 0.25)
    {
      device.Put({x, 0.0, 0.0}, 0);
      const std::int64_t put = this->Time.Now();
      this->WaitUntil([&](const StudyTouchReading& now) { return now.Newest.Tick.Started > put; });
    }
  }
  // Polls until `holds`, while the servo's own time passes.
  template <typename Condition>
  const StudyTouchReading& WaitUntil(const Condition& holds)
  {
    while (!holds(this->Touch.Poll()))
    {
      std::this_thread::yield();
    }
    return this->Touch.Poll();
  }
  // The reading once hand and ramp are at rest, after 2 s of servo time.
  const StudyTouchReading& AtRest()
  {
    const std::int64_t end = this->Time.Now() + 2'000'000'000;
    return this->WaitUntil([&](const StudyTouchReading& now)
                           { return now.Newest.Tick.Started > end; });
  }

  std::uint64_t Expected = 2; // scene
  ManualClock Time;
  StudyState State = SphereState(7);
  std::vector<SceneContact> Contacts{Sphere(7, Radius)};
  StudyTouch Touch{Time, Ordinary()};
};

TEST_F(StudyTouchTest, ReportsForceAndTouchedStructure)
{
  this->Start();
  EXPECT_TRUE(this->Touch.IsRunning());
  this->Press(4.0);
  const StudyTouchReading& felt = this->AtRest();
  EXPECT_EQ(felt.TouchedId, 7);
  // Hand and structure share the distance as springs of 0.5 N/mm each; the mechanism's friction of
  // 0.2 N may hold 0.2 mm of it.
  EXPECT_NEAR(felt.Newest.Depth, 2.0, 0.25);
  EXPECT_NEAR(Vector3(felt.Newest.ForceWorld).x(), 0.5 * felt.Newest.Depth, 1e-2);
  EXPECT_EQ(felt.Safety, "Forces are on.");
  EXPECT_GT(felt.Durations.Count(), 0U);
  this->Touch.Stop();
  EXPECT_FALSE(this->Touch.IsRunning());
  EXPECT_EQ(Vector3(this->Touch.Poll().Newest.ForceDevice), Vector3::Zero());
}

TEST_F(StudyTouchTest, StiffnessChangesDuringContact)
{
  this->Start();
  this->Press(4.0);
  const double before = this->AtRest().Newest.ForceWorld.X;
  const std::uint64_t scene = this->Touch.Poll().Newest.Scene;
  this->State.Structures[0].Stiffness = 1.5;
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  const StudyTouchReading& after = this->AtRest();
  EXPECT_EQ(after.Newest.Scene, scene + 1);
  // A hand that rests feels no more than before; one that comes again feels 1.5 N instead of 1 N,
  // as 4 mm are shared as 1 to 3 and no longer as 1 to 1.
  EXPECT_NEAR(after.Newest.ForceWorld.X, before, 0.05);
  this->Press(4.0);
  EXPECT_GT(this->AtRest().Newest.ForceWorld.X, 1.25 * before);
}

TEST_F(StudyTouchTest, RefittedModelIsSwappedIn)
{
  this->Start();
  this->Press(2.0);
  this->AtRest();
  const Vector3 center = this->Touch.Frame().CenterWorld;
  const double scale = this->Touch.Frame().Scale;
  this->Contacts = {Sphere(7, Radius - 10.0)};
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  EXPECT_EQ(this->AtRest().TouchedId, 0) << "the hand is outside of the smaller sphere";
  EXPECT_EQ(this->Touch.Frame().CenterWorld, center) << "the workspace stays where it is";
  EXPECT_EQ(this->Touch.Frame().Scale, scale);
}

// The device stands still and the force acts throughout: nothing fades in again.
TEST_F(StudyTouchTest, ForcesContinueAcrossSceneChanges)
{
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  device->Put({Radius + 1.0, 0.0, 0.0}, 0);
  this->State.Placement.Scale = 1.0;
  ASSERT_TRUE(this->Touch.Start(std::move(owned), this->State, this->Contacts).IsOk());
  this->Press(*device, 2.0);
  this->AtRest();
  ASSERT_NEAR(device->Force(), 1.0, 1e-9);
  const auto expectSame = [&]
  {
    ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
    const StudyTouchReading& last = this->WaitUntil(
        [&](const StudyTouchReading& now)
        {
          for (const TouchState& tick : now.NewTicks)
          {
            EXPECT_NEAR(Vector3(tick.ForceDevice).norm(), 1.0, 1e-3);
            EXPECT_FALSE(tick.Safety.IsRamping);
          }
          return now.Newest.Scene == this->Expected;
        });
    EXPECT_EQ(last.TouchedId, 7);
    EXPECT_NEAR(Vector3(this->AtRest().Newest.ForceDevice).norm(), 1.0, 1e-3);
    ++this->Expected;
  };
  this->State.Structures[0].Stiffness = 1.0;
  expectSame();
  this->Contacts = {Sphere(7, Radius + 1.0)};
  expectSame();
  this->State.Placement.CenterWorld = Vector3(-0.5, 0.0, 0.0);
  expectSame();
}

TEST_F(StudyTouchTest, IrrelevantChangesAreNotPublished)
{
  this->Start();
  const std::uint64_t scene = this->AtRest().Newest.Scene;
  this->State.Structures[0].Color = {{0.0, 0.0, 1.0}};
  this->State.View.OverlayOpacity = 0.9;
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  EXPECT_EQ(this->AtRest().Newest.Scene, scene);
}

TEST_F(StudyTouchTest, SwitchedOffForcesStayOff)
{
  this->Start();
  this->Press(4.0);
  ASSERT_GT(this->AtRest().Newest.ForceWorld.X, 0.5);
  this->Touch.SwitchForcesOff();
  const StudyTouchReading& off = this->AtRest();
  EXPECT_EQ(Vector3(off.Newest.ForceDevice), Vector3::Zero());
  EXPECT_EQ(off.Newest.Safety.Fault, SafetyFault::SwitchedOff);
  EXPECT_NEAR(off.Newest.ProbeWorld.X, Radius - 4.0, 0.5) << "the hand is still tracked";
  this->Touch.SwitchForcesOn();
  this->Press(4.0);
  EXPECT_GT(this->AtRest().Newest.ForceWorld.X, 0.5);
}

// The touch is not polled meanwhile, as with a hanging window.
TEST_F(StudyTouchTest, SecondRequestToEndRemovesTheForce)
{
  const Interruption interruption;
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  device->Put({Radius + 1.0, 0.0, 0.0}, 0);
  this->State.Placement.Scale = 1.0;
  ASSERT_TRUE(this->Touch.Start(std::move(owned), this->State, this->Contacts).IsOk());
  this->Press(*device, 2.0);
  this->AtRest();
  std::raise(SIGTERM);
  this->AtRest();
  ASSERT_NEAR(device->Force(), 1.0, 1e-9);
  std::raise(SIGTERM);
  const std::int64_t end = this->Time.Now() + 1'000'000'000;
  while (this->Time.Now() < end)
  {
    std::this_thread::yield();
  }
  EXPECT_EQ(device->Force(), 0.0);
  EXPECT_EQ(this->AtRest().Newest.Safety.Fault, SafetyFault::SwitchedOff);
}

// Reports the last force before it was closed.
class SayingDevice final : public test::PlacedDevice
{
public:
  using PlacedDevice::PlacedDevice;
  void Close() noexcept override
  {
    std::fprintf(stderr, "closed with %g N", this->Force());
    PlacedDevice::Close();
  }
};

using StudyTouchDeathTest = StudyTouchTest;

// As an X library does after its server has gone.
TEST_F(StudyTouchDeathTest, AbruptExitClosesTheDeviceWithoutForce)
{
  EXPECT_EXIT(
      {
        auto device = std::make_unique<SayingDevice>(this->Time);
        SayingDevice* hand = device.get();
        hand->Put({Radius + 1.0, 0.0, 0.0}, 0);
        this->State.Placement.Scale = 1.0;
        static_cast<void>(this->Touch.Start(std::move(device), this->State, this->Contacts));
        this->Press(*hand, 2.0);
        const Vector3 force = this->AtRest().Newest.ForceDevice;
        std::fprintf(stderr, "pushed with %g N, ", force.norm());
        std::exit(3);
      },
      testing::ExitedWithCode(3), "^pushed with 1 N, closed with 0 N$");
}

TEST_F(StudyTouchTest, UntouchableStructureLetsTheHandIn)
{
  this->Start();
  this->Press(4.0);
  this->AtRest();
  this->State.Structures[0].IsTouchable = false;
  ASSERT_TRUE(this->Touch.Update(this->State, {}).IsOk());
  EXPECT_EQ(this->AtRest().TouchedId, 0);
}

// Reports refer to the structure that was touched.
TEST_F(StudyTouchTest, ReportsTheTouchedOfSeveralStructures)
{
  this->State.Structures.insert(this->State.Structures.begin(),
                                test::StudyPhantom::Structure(3, TouchRepresentation::Harmonics));
  this->Contacts = {Sphere(3, 0.5 * Radius), Sphere(7, Radius)};
  this->Start();
  this->Press(4.0);
  EXPECT_EQ(this->AtRest().TouchedId, 7);
}

TEST_F(StudyTouchTest, DoesNotStartWithoutContacts)
{
  const Status status = this->Touch.Start(this->OpenDevice(this->Time), this->State, {});
  EXPECT_NE(status.Message().find("nothing to touch"), std::string::npos) << status.Message();
  EXPECT_FALSE(this->Touch.IsRunning());
}

TEST_F(StudyTouchTest, RejectsUnusableToolAndKeepsThePrevious)
{
  this->State.Tool.Radius = -1.0;
  EXPECT_FALSE(this->Touch.Start(this->OpenDevice(this->Time), this->State, this->Contacts).IsOk());
  this->State.Tool.Radius = 0.0;
  this->Start();
  this->State.Tool.Kind = TouchToolSettings::Shape::Ellipsoid;
  this->State.Tool.SemiAxes.x() = -1.0;
  EXPECT_FALSE(this->Touch.Update(this->State, this->Contacts).IsOk());
  this->Press(4.0);
  EXPECT_EQ(this->AtRest().TouchedId, 7);
}

TEST_F(StudyTouchTest, PlacementDefinesTheWorkspace)
{
  this->State.Placement.Scale = 2.0;
  this->State.Placement.CenterWorld = Vector3(5.0, 6.0, 7.0);
  const Matrix3 turned = Eigen::AngleAxisd(0.5 * M_PI, Vector3::UnitZ()).toRotationMatrix();
  this->Touch.TurnAxes(turned);
  this->Start();
  EXPECT_EQ(this->Touch.Frame().Scale, 2.0);
  EXPECT_EQ(this->Touch.Frame().Rotation, turned);
  const Vector3 target(30.0, -10.0, 12.0);
  this->Touch.MoveHand(target);
  // One count of the encoders is 0.045 mm, 0.09 mm at this scale; friction holds 0.2 N / 0.5 N/mm.
  EXPECT_LT((Vector3(this->AtRest().Newest.ProbeWorld) - target).norm(), 2.0 * (0.4 + 0.1));
  this->State.Placement.AxesFollowCamera = false;
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  EXPECT_EQ(this->Touch.Frame().Rotation, Matrix3(Matrix3::Identity()));
}

TEST_F(StudyTouchTest, HandStaysInTheWorkspace)
{
  this->State.Placement.Scale = 2.0;
  this->State.Placement.CenterWorld = Vector3(5.0, 6.0, 7.0);
  this->Start();
  const double reach = this->Touch.Capabilities().Workspace.max().x();
  ASSERT_TRUE(this->Touch.MoveHand(Vector3(1000.0, 6.0, -1000.0)));
  const Vector3 corner(5.0 + 2.0 * reach, 6.0, 7.0 - 2.0 * reach);
  // A few roundings of numbers of a few hundred mm.
  EXPECT_LT((this->Touch.HandWorld() - corner).norm(), 1e-10);
  EXPECT_LT((Vector3(this->AtRest().Newest.ProbeWorld) - corner).norm(), 2.0 * (0.6 + 0.1));
  // It moves with the workspace.
  this->State.Placement.CenterWorld = Vector3(15.0, 6.0, 7.0);
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  EXPECT_LT((this->Touch.HandWorld() - corner - Vector3(10.0, 0.0, 0.0)).norm(), 1e-10);
  this->Touch.Stop();
  EXPECT_FALSE(this->Touch.MoveHand(Vector3::Zero()));
}

TEST_F(StudyTouchTest, ClutchHoldsTheToolAndMovesTheWorkspace)
{
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  constexpr unsigned Clutch = 1U << StudyTouch::ClutchButton;
  device->Put({Radius - 2.0, 0.0, 0.0}, 0);
  ASSERT_TRUE(this->Touch.Start(std::move(owned), this->State, this->Contacts).IsOk());
  const double scale = this->Touch.Frame().Scale;
  device->Put({(Radius - 2.0) / scale, 0.0, 0.0}, Clutch);
  this->WaitUntil([](const StudyTouchReading& now) { return now.IsClutched; });
  const Vector3 held = this->Touch.Poll().Newest.ProbeWorld;
  this->WaitUntil([&](const StudyTouchReading&) { return device->Force() == 0.0; });
  for (double x = (Radius - 2.0) / scale; x > 0.0; x -= 0.25)
  {
    device->Put({x, 0.0, 0.0}, Clutch);
    const std::int64_t put = this->Time.Now();
    this->WaitUntil([&](const StudyTouchReading& now) { return now.Newest.Tick.Started > put; });
  }
  EXPECT_EQ(Vector3(this->Touch.Poll().Newest.ProbeWorld), held);
  EXPECT_EQ(device->Force(), 0.0);
  device->Put({0.0, 0.0, 0.0}, 0);
  this->WaitUntil([](const StudyTouchReading& now) { return !now.IsClutched; });
  // The tool comes back inside the structure, which is silent until it has left.
  EXPECT_EQ(this->AtRest().Newest.Depth, 0.0);
  EXPECT_TRUE(this->Touch.Poll().Newest.IsBuried);
  EXPECT_LT((Vector3(this->Touch.Poll().Newest.ProbeWorld) - held).norm(), 1e-9);
  // Later changes keep the moved workspace.
  this->State.Structures[0].Stiffness *= 0.5;
  ASSERT_TRUE(this->Touch.Update(this->State, this->Contacts).IsOk());
  EXPECT_LT((this->Touch.Frame().CenterWorld - held).norm(), 1e-9);
}

// Independently of the polling rate.
TEST_F(StudyTouchTest, DeviceButtonDrillsInTheTickThatReadsIt)
{
  constexpr unsigned Button = 1U << StudyTouch::DrillButton;
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  device->Put(Vector3::Zero(), 0);
  ASSERT_TRUE(this->Touch.Start(std::move(owned), this->State, this->Contacts).IsOk());
  for (const unsigned buttons : {0U, Button, 0U})
  {
    device->Put(Vector3::Zero(), buttons);
    bool isSeen = false;
    while (!isSeen)
    {
      for (const TouchState& tick : this->Touch.Poll().NewTicks)
      {
        ASSERT_EQ(tick.IsDrilling, tick.Sample.Buttons == Button) << tick.Tick.Number;
        isSeen = isSeen || tick.Sample.Buttons == buttons;
      }
    }
  }
}

// A recording restarts the servo, which must not lose the state of buttons.
TEST_F(StudyTouchTest, ClutchReleasedWhileARecordingStartsIsReleased)
{
  const test::TemporaryFolder folder;
  auto owned = std::make_unique<test::PlacedDevice>(this->Time);
  test::PlacedDevice* device = owned.get();
  device->Put(Vector3::Zero(), 1U << StudyTouch::ClutchButton);
  ASSERT_TRUE(this->Touch.Start(std::move(owned), this->State, this->Contacts).IsOk());
  this->WaitUntil([](const StudyTouchReading& now) { return now.IsClutched; });
  device->Put(Vector3::Zero(), 0);
  ASSERT_TRUE(this->Touch.StartRecording(folder / "session.touch").IsOk());
  EXPECT_FALSE(this->AtRest().IsClutched);
}

TEST_F(StudyTouchTest, ReportsUnpluggedDevice)
{
  auto device = this->OpenDevice(this->Time);
  auto* simulated = dynamic_cast<SimulatedDevice*>(device.get());
  ASSERT_TRUE(this->Touch.Start(std::move(device), this->State, this->Contacts).IsOk());
  this->AtRest();
  simulated->Inject(SimulatedFault::Unplugged);
  const StudyTouchReading& reading = this->WaitUntil(
      [](const StudyTouchReading& now) { return now.Newest.Safety.Fault != SafetyFault::None; });
  EXPECT_EQ(reading.Newest.Safety.Fault, SafetyFault::DeviceFailed);
  EXPECT_NE(reading.Safety.find("unplugged"), std::string::npos);
  EXPECT_NE(reading.DeviceProblem.find("unplugged"), std::string::npos);
  this->Start();
  // The hand starts in the sphere's centre.
  EXPECT_EQ(this->AtRest().Safety, "Forces are on. The tool is inside a structure, which is felt "
                                   "once the tool has left it.");
}

TEST_F(StudyTouchTest, MessageNamesUnknownDevice)
{
  std::unique_ptr<HapticDevice> device;
  const Status status = OpenBuiltInDevice("phantom", this->Time, device);
  EXPECT_NE(status.Message().find("simulated"), std::string::npos) << status.Message();
}

// Not faster than real time, since the ring of an unthrottled servo overflows.
TEST_F(StudyTouchTest, RecordingReplaysBitForBit)
{
  const test::TemporaryFolder folder;
  test::PacedClock clock;
  StudyTouch touch(clock, Ordinary());
  ASSERT_TRUE(touch.Start(this->OpenDevice(clock), this->State, this->Contacts).IsOk());
  const auto file = folder / "session.touch";
  ASSERT_TRUE(touch.StartRecording(file).IsOk());
  EXPECT_FALSE(touch.StartRecording(file).IsOk());
  touch.MoveHand(Vector3(Radius - 4.0, 0.0, 0.0));
  while (touch.Poll().Newest.Tick.Number < 150 || touch.Poll().TouchedId != 7)
  {
    std::this_thread::yield();
  }
  touch.Stop();
  EXPECT_EQ(touch.Poll().RecordingProblem, "");
  EXPECT_EQ(touch.Poll().Newest.Safety.Fault, SafetyFault::None);
  auto recording = std::make_shared<TouchRecording>();
  ASSERT_TRUE(ReadTouchRecording(file.string(), *recording).IsOk());
  EXPECT_GE(recording->Ticks.size(), 150U);
  EXPECT_EQ(touch.Poll().RecordedTicks, recording->Ticks.size());
  EXPECT_EQ(touch.RecordingFile(), file);
  WorkspaceFrame frame = touch.Frame();
  const auto scene =
      std::make_shared<const TouchScene>(MakeTouchScene(this->State, this->Contacts, frame));
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, {scene}, comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0U);
}

TEST_F(StudyTouchTest, RecordingDoesNotSwitchForcesOnAgain)
{
  const test::TemporaryFolder folder;
  test::PacedClock clock;
  StudyTouch touch(clock, Ordinary());
  ASSERT_TRUE(touch.Start(this->OpenDevice(clock), this->State, this->Contacts).IsOk());
  touch.SwitchForcesOff();
  while (touch.Poll().Newest.Safety.Fault != SafetyFault::SwitchedOff)
  {
    std::this_thread::yield();
  }
  const auto file = folder / "session.touch";
  ASSERT_TRUE(touch.StartRecording(file).IsOk());
  touch.MoveHand(Vector3(Radius + 5.0, 0.0, 0.0));
  while (touch.Poll().Newest.Tick.Number < 150 || touch.Poll().Newest.ProbeWorld.X < Radius + 4.0)
  {
    std::this_thread::yield();
  }
  touch.SwitchForcesOn();
  while (touch.Poll().Newest.Safety.Fault != SafetyFault::None)
  {
    std::this_thread::yield();
  }
  touch.MoveHand(Vector3(Radius - 4.0, 0.0, 0.0));
  while (touch.Poll().TouchedId != 7 || touch.Poll().Newest.Safety.Fault != SafetyFault::None)
  {
    std::this_thread::yield();
  }
  touch.Stop();
  auto recording = std::make_shared<TouchRecording>();
  ASSERT_TRUE(ReadTouchRecording(file.string(), *recording).IsOk());
  for (std::size_t tick = 0; tick < 150; ++tick)
  {
    ASSERT_EQ(recording->Ticks[tick].Safety.Fault, SafetyFault::SwitchedOff) << tick;
    ASSERT_EQ(Vector3(recording->Ticks[tick].ForceDevice).norm(), 0.0) << tick;
  }
  WorkspaceFrame frame = touch.Frame();
  const auto scene =
      std::make_shared<const TouchScene>(MakeTouchScene(this->State, this->Contacts, frame));
  ReplayComparison comparison;
  ASSERT_TRUE(ReplayTouch(recording, {scene}, comparison).IsOk());
  EXPECT_EQ(comparison.DifferentTicks, 0U);
}

TEST_F(StudyTouchTest, FailedRecordingIsReportedAndTouchContinues)
{
  EXPECT_FALSE(this->Touch.StartRecording("/nowhere/session.touch").IsOk());
  this->Start();
  EXPECT_FALSE(this->Touch.StartRecording("/nowhere/session.touch").IsOk());
  EXPECT_FALSE(this->Touch.IsRecording());
  EXPECT_FALSE(this->Touch.StopRecording().IsOk());
  this->Press(4.0);
  EXPECT_EQ(this->AtRest().TouchedId, 7);
}

// From files to a touch, with a pipeline's products.
TEST(StudyTouchOfFiles, TouchesThePipelinesProducts)
{
  const test::StudyPhantom phantom;
  StudyState state = phantom.State();
  StudyJobs jobs;
  StudyPipeline pipeline(jobs);
  pipeline.Update(state);
  EXPECT_TRUE(test::ContactsIn(state, pipeline).empty());
  test::Settle(jobs);
  ManualClock clock;
  StudyTouch touch(clock, Ordinary());
  std::unique_ptr<HapticDevice> device;
  ASSERT_TRUE(OpenBuiltInDevice(state.Device, clock, device).IsOk());
  ASSERT_TRUE(touch.Start(std::move(device), state, test::ContactsIn(state, pipeline)).IsOk());
  // Out of the sphere, whose centre is at x = -15, and into it again.
  touch.MoveHand(Vector3(-15.0, 0.0, 16.0));
  while (touch.Poll().Newest.ProbeWorld.Z < 14.0)
  {
    std::this_thread::yield();
  }
  touch.MoveHand(Vector3(-15.0, 0.0, 5.0));
  while (touch.Poll().TouchedId != 1)
  {
    std::this_thread::yield();
  }
}

TEST(SafetyText, DescribesTheSafetyChain)
{
  TouchState state;
  EXPECT_EQ(SafetyText(state), "Forces are off: the device is closed.");
  state.State = DeviceState::Homing;
  EXPECT_NE(SafetyText(state).find("homing"), std::string::npos);
  state.State = DeviceState::Ready;
  state.Safety.IsArmed = true;
  EXPECT_EQ(SafetyText(state), "Forces are on.");
  state.Safety.IsRamping = true;
  state.Safety.IsLimited = true;
  EXPECT_EQ(SafetyText(state),
            "Forces are on. They are being faded in. They are limited to the device's maximum.");
  state.Safety.Fault = SafetyFault::SwitchedOff;
  EXPECT_EQ(SafetyText(state), Describe(SafetyFault::SwitchedOff));
}

TEST(SafetyText, SaysThatTouchingGoesOnByItself)
{
  TouchState state;
  state.State = DeviceState::Ready;
  state.Safety.Fault = SafetyFault::StalledTick;
  state.Safety.WillResume = true;
  EXPECT_EQ(SafetyText(state), "The servo was delayed for too long: touching goes on by itself.");
}
} // namespace
} // namespace palpate::study_touch_test
