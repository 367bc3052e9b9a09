#include "StudyTouch.h"

#include "InputError.h"
#include "SafetyText.h"
#include "SimulatedDevice.h"
#include "StiffnessAdvice.h"
#include "TouchRecorder.h"
#include "TouchStandIns.h"

#include <algorithm>
#include <utility>

namespace palpate
{
StudyTouch::StudyTouch(Clock& clock, const RealtimeRequest& request) : Time(clock), Request(request)
{
}

StudyTouch::~StudyTouch()
{
  this->Stop();
}

bool StudyTouch::IsSame(const Feelable& a, const Feelable& b)
{
  const auto isSameOne = [](const Feelable::One& one, const Feelable::One& other)
  {
    return one.Label == other.Label && one.Contact == other.Contact &&
           one.Stiffness == other.Stiffness && one.Friction.Static == other.Friction.Static &&
           one.Friction.Dynamic == other.Friction.Dynamic && one.Drill.Wear == other.Drill.Wear &&
           one.Drill.Drag == other.Drill.Drag && one.Drill.Vibration == other.Drill.Vibration;
  };
  return a.Tool == b.Tool && a.Frame == b.Frame && a.DrillRevision == b.DrillRevision &&
         std::equal(a.Structures.begin(), a.Structures.end(), b.Structures.begin(),
                    b.Structures.end(), isSameOne);
}

Status StudyTouch::Start(std::unique_ptr<HapticDevice> opened, const StudyState& state,
                         const std::vector<StudyContact>& contacts)
{
  this->Stop();
  this->Device = std::move(opened);
  this->End = std::make_unique<EndBeforeExit>([this] { this->Stop(); });
  this->Settings = {};
  this->Settings.Rate = state.Rate;
  this->Settings.PedalButtons = 1U << DrillButton;
  this->Felt = {};
  this->Scene.reset();
  this->Automatic.reset();
  this->Watch = {};
  this->Clutch = {};
  this->Moved.setZero();
  this->Hand.setZero();
  Status status =
      contacts.empty()
          ? Status::Failure("There is nothing to touch yet: make a structure touchable and wait "
                            "until its model is made.")
          : this->Publish(state, contacts);
  if (status.IsOk())
  {
    status = this->StartServo();
  }
  if (!status.IsOk())
  {
    this->Stop();
  }
  return status;
}

Status StudyTouch::StartServo()
{
  this->Thread = std::make_unique<ServoThread>(*this->Device, this->Time, this->Settings);
  this->Drilled.Start();
  Status status = this->Send(this->Scene, SceneEntry::Anew);
  if (status.IsOk())
  {
    status = this->Thread->Start(this->Request);
  }
  return status;
}

// To the servo; while the clutch is held, without what could be felt.
Status StudyTouch::Send(std::shared_ptr<const TouchScene> scene, SceneEntry entry)
{
  if (this->Clutch.IsHeld())
  {
    auto empty = std::make_shared<TouchScene>(*scene);
    empty->Structures.clear();
    scene = std::move(empty);
  }
  return this->Thread->Loop().Publish(std::move(scene), entry);
}

void StudyTouch::HoldClutch(bool isHeld, const TouchState& now)
{
  if (isHeld == this->Clutch.IsHeld())
  {
    return;
  }
  if (isHeld)
  {
    this->Clutch.Hold(now.ProbeWorld);
  }
  else
  {
    const WorkspaceFrame moved = this->Clutch.Release(this->Felt.Frame, now.Sample.Position);
    this->Moved += moved.CenterWorld - this->Felt.Frame.CenterWorld;
    this->Felt.Frame = moved;
    auto scene = std::make_shared<TouchScene>(*this->Scene);
    scene->Frame = moved.ForDevice();
    this->Scene = std::move(scene);
  }
  // The scene was felt before: it is not refused.
  static_cast<void>(this->Send(this->Scene, SceneEntry::Anew));
}

void StudyTouch::Stop()
{
  if (this->Thread != nullptr)
  {
    this->Thread->Stop();
    this->Drilled.Stop();
    if (this->IsRecording())
    {
      const Status status = this->StopRecording();
      this->Reading.RecordingProblem = status.Message();
    }
    this->Thread.reset();
    const std::string problem = this->Reading.RecordingProblem;
    const std::uint64_t recorded = this->Reading.RecordedTicks;
    this->Reading = {};
    this->Reading.RecordingProblem = problem;
    this->Reading.RecordedTicks = recorded;
  }
  if (this->Device != nullptr)
  {
    this->Device->Close();
    this->Device.reset();
    this->End.reset();
  }
}

Status StudyTouch::Update(const StudyState& state, const std::vector<StudyContact>& contacts)
{
  return this->IsRunning() ? this->Publish(state, contacts) : Status::Success();
}

WorkspaceFrame StudyTouch::FrameFor(const StudyPlacement& placement, const TouchScene& scene)
{
  if (!this->Automatic)
  {
    this->Automatic = WorkspaceFrame::Around(scene, this->Device->Capabilities());
  }
  WorkspaceFrame frame;
  frame.Rotation = placement.AxesFollowCamera ? this->CameraAxes : Matrix3(Matrix3::Identity());
  frame.Scale = placement.Scale.value_or(this->Automatic->Scale);
  frame.CenterWorld = placement.CenterWorld.value_or(this->Automatic->CenterWorld) + this->Moved;
  return frame;
}

Status StudyTouch::Publish(const StudyState& state, const std::vector<StudyContact>& contacts)
{
  Status status = this->PublishAll(state, contacts);
  if (!status.IsOk() && this->IsRunning() && !this->Drilled.Protects(this->Forbidden))
  {
    this->HoldDrill();
  }
  return status;
}

// What was felt before goes on, and nothing of it is cut: that scene does not protect all.
void StudyTouch::HoldDrill()
{
  auto held = std::make_shared<TouchScene>(*this->Scene);
  for (std::size_t s = 0; s < held->Structures.size(); ++s)
  {
    held->Structures[s].Drill = {};
    this->Felt.Structures[s].Drill = {};
  }
  this->Thread->Loop().LiftPedals();
  this->Scene = std::move(held);
  // The scene was felt before: it is not refused.
  static_cast<void>(this->Send(this->Scene, SceneEntry::Continuing));
}

Status StudyTouch::PublishAll(const StudyState& state, const std::vector<StudyContact>& contacts)
{
  try
  {
    const std::vector<StudyContact> touchable = TouchableOf(state, contacts);
    auto scene = std::make_shared<TouchScene>(MakeStudyScene(state, touchable, {}));
    const bool wasHeld = !this->Drilled.Hold().empty();
    this->Drilled.Follow(state, touchable, this->Forbidden);
    this->Drilled.PutInto(*scene);
    if (this->IsRunning() && wasHeld != !this->Drilled.Hold().empty())
    {
      // A pedal that was held meanwhile must not begin to cut by itself.
      this->Thread->Loop().LiftPedals();
    }
    Feelable next;
    next.Tool = state.Tool;
    next.DrillRevision = this->Drilled.Revision();
    const SceneEntry entry = this->Automatic ? SceneEntry::Continuing : SceneEntry::Anew;
    next.Frame = this->FrameFor(state.Placement, *scene);
    for (std::size_t s = 0; s < scene->Structures.size(); ++s)
    {
      const TouchStructure& one = scene->Structures[s];
      next.Structures.push_back(
          {touchable[s].Label, touchable[s].Contact, one.Law.Stiffness, one.Friction, one.Drill});
    }
    if (this->Scene != nullptr && IsSame(next, this->Felt))
    {
      return Status::Success();
    }
    scene->Frame = next.Frame.ForDevice();
    Status status = scene->Check();
    if (status.IsOk() && this->IsRunning())
    {
      status = this->Send(scene, entry);
    }
    if (status.IsOk())
    {
      this->Advice = StiffnessWarnings(*scene, this->Device->Capabilities(), this->Settings.Rate);
      this->Scene = std::move(scene);
      this->Felt = std::move(next);
    }
    return status;
  }
  catch (const std::runtime_error& error)
  {
    return Status::Failure(error.what());
  }
}

void StudyTouch::RunDrill(bool runs)
{
  if (this->IsRunning())
  {
    this->Thread->Loop().RunDrill(runs);
  }
}

void StudyTouch::Command(DrillCommand command)
{
  if (this->IsRunning())
  {
    static_cast<void>(this->Thread->Loop().Command(command));
  }
}

void StudyTouch::SwitchForcesOff()
{
  if (this->IsRunning())
  {
    this->Thread->Loop().SwitchOff();
  }
}

void StudyTouch::SwitchForcesOn()
{
  if (this->IsRunning())
  {
    this->Thread->Loop().Rearm();
  }
}

bool StudyTouch::MoveHand(const Vector3& targetWorld)
{
  return this->Device != nullptr && this->LeadHand(this->Felt.Frame.NearestInReach(
                                        targetWorld, this->Capabilities().Workspace));
}

bool StudyTouch::PlaceHand(const Vector3& towardsViewerWorld)
{
  return this->Device != nullptr && this->LeadHand(this->Felt.Frame.FirstHand(
                                        towardsViewerWorld, this->Capabilities().Workspace));
}

bool StudyTouch::LeadHand(const Vector3& handDevice)
{
  auto* simulated = dynamic_cast<SimulatedDevice*>(this->Device.get());
  if (simulated != nullptr)
  {
    this->Hand = handDevice;
    simulated->SetTarget(handDevice);
  }
  return simulated != nullptr;
}

void StudyTouch::TakeTicks()
{
  using Kind = TouchChange::Kind;
  Servo& servo = this->Thread->Loop();
  std::vector<TouchChange> changes;
  for (TouchState state; servo.PopRecorded(state);)
  {
    this->Reading.NewTicks.push_back(state);
    this->Watch.Take(state, changes);
    if (this->IsRecording())
    {
      const Status status = this->Recorder->Take(state);
      ++this->Reading.RecordedTicks;
      if (!status.IsOk())
      {
        this->Reading.RecordingProblem = status.Message();
        this->Recorder.reset();
      }
    }
  }
  for (const TouchChange& change : changes)
  {
    const bool isPress = change.What == Kind::ButtonPressed;
    if ((isPress || change.What == Kind::ButtonReleased) && change.Button == ClutchButton)
    {
      this->HoldClutch(isPress, this->Reading.NewTicks.back());
    }
  }
}

const StudyTouchReading& StudyTouch::Poll()
{
  this->Reading.NewTicks.clear();
  if (!this->IsRunning())
  {
    return this->Reading;
  }
  this->TakeTicks();
  Servo& servo = this->Thread->Loop();
  servo.Reclaim();
  this->Reading.Newest = servo.Latest();
  this->Reading.IsClutched = this->Clutch.IsHeld();
  if (this->Reading.IsClutched)
  {
    this->Reading.Newest.ProbeWorld = this->Clutch.PlaceWorld();
    this->Reading.Newest.ProxyWorld = this->Clutch.PlaceWorld();
  }
  this->Reading.LostTicks = servo.LostTicks();
  const auto touched = static_cast<std::size_t>(this->Reading.Newest.Structure);
  this->Reading.TouchedLabel =
      touched < this->Felt.Structures.size() ? this->Felt.Structures[touched].Label : 0;
  this->Reading.Safety = this->Reading.IsClutched
                             ? "The clutch is held: nothing is felt, and the tool stays."
                             : SafetyText(this->Reading.Newest);
  this->Reading.Degraded = LevelText(*this->Scene, this->Reading.Newest.Level,
                                     this->Reading.Newest.Structure, this->Settings.Rate);
  this->Reading.DeviceProblem = this->Device->Problem();
  this->Reading.Guidance = this->Device->Guidance();
  this->Reading.Drill =
      this->Drilled.Read(1e-9 * static_cast<double>(this->Time.Now()), this->Reading.Newest);
  const ServoStatistics& statistics = this->Thread->Statistics();
  this->Reading.Periods = statistics.Periods;
  this->Reading.Durations = statistics.Durations;
  return this->Reading;
}

Status StudyTouch::StartRecording(const std::filesystem::path& path)
{
  if (!this->IsRunning())
  {
    return Status::Failure("Nothing is touched: start the touch, then record it.");
  }
  if (this->IsRecording())
  {
    return Status::Failure("A recording is going on already.");
  }
  auto recorder = std::make_unique<TouchRecorder>();
  Status status = recorder->Start(path.string(), {this->Settings, this->Device->Capabilities()});
  if (status.IsOk())
  {
    this->Thread->Stop();
    this->Recorder = std::move(recorder);
    this->RecordedTo = path;
    this->Reading.RecordedTicks = 0;
    this->Reading.RecordingProblem.clear();
    status = this->StartServo();
    if (!status.IsOk())
    {
      this->Stop();
    }
  }
  return status;
}

Status StudyTouch::StopRecording()
{
  if (!this->IsRecording())
  {
    return Status::Failure("There is no recording to be ended.");
  }
  this->TakeTicks();
  if (!this->IsRecording())
  {
    return Status::Failure(this->Reading.RecordingProblem);
  }
  Status status = this->Recorder->Finish();
  this->Recorder.reset();
  return status;
}
} // namespace palpate
