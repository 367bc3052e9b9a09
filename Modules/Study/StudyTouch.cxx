#include "StudyTouch.h"

#include "ExceptionMessage.h"
#include "InputError.h"
#include "SafetyText.h"
#include "StiffnessAdvice.h"

#include <algorithm>
#include <utility>

namespace palpate
{
StudyTouch::StudyTouch(Clock& clock, const RealtimeRequest& request)
    : Time(clock), Session(clock, request)
{
  this->Session.SetClutchButton(ClutchButton);
}

bool StudyTouch::IsSame(const Feelable& a, const Feelable& b)
{
  const auto isSameLaw = [](const DrillLaw& one, const DrillLaw& other)
  { return one.Wear == other.Wear && one.Drag == other.Drag && one.Vibration == other.Vibration; };
  const auto isSameContact = [](const SceneContact& one, const SceneContact& other)
  { return one.Id == other.Id && one.Contact == other.Contact && one.Effects == other.Effects; };
  const auto isFeltAlike = [](const SceneStructure& one, const SceneStructure& other)
  {
    return one.Stiffness == other.Stiffness && one.Damping == other.Damping &&
           one.Friction.Static == other.Friction.Static &&
           one.Friction.Dynamic == other.Friction.Dynamic && one.Numbers == other.Numbers;
  };
  return a.Tool == b.Tool && a.Guides == b.Guides && a.Distances == b.Distances &&
         a.Held == b.Held && a.Frame == b.Frame && a.DrillRevision == b.DrillRevision &&
         std::equal(a.Contacts.begin(), a.Contacts.end(), b.Contacts.begin(), b.Contacts.end(),
                    isSameContact) &&
         std::equal(a.Structures.begin(), a.Structures.end(), b.Structures.begin(),
                    b.Structures.end(), isFeltAlike) &&
         std::equal(a.Laws.begin(), a.Laws.end(), b.Laws.begin(), b.Laws.end(), isSameLaw);
}

Status StudyTouch::Start(std::unique_ptr<HapticDevice> opened, const StudyState& state,
                         const std::vector<SceneContact>& contacts, bool staysOff)
{
  this->Stop();
  this->Settings = {};
  this->Settings.Rate = state.Rate;
  this->Settings.PedalButtons = 1U << DrillButton;
  this->Felt = {};
  this->Automatic.reset();
  this->MovedBefore.setZero();
  this->Session.Open(std::move(opened), this->Settings);
  Status status =
      contacts.empty()
          ? Status::Failure("There is nothing to touch yet: make a structure touchable and wait "
                            "until its model is made.")
          : this->Publish(state, contacts);
  if (status.IsOk())
  {
    this->Drilled.FollowNextServo();
    status = this->Session.Start(*this->Session.Scene(), this->Felt.Frame, staysOff);
  }
  if (!status.IsOk())
  {
    this->Stop();
  }
  return status;
}

void StudyTouch::Stop()
{
  this->Session.Stop();
  this->Drilled.Finish();
  this->Held.reset();
  const TouchSessionReading& last = this->Session.Poll();
  this->Reading = {};
  this->Reading.RecordedTicks = last.RecordedTicks;
  this->Reading.RecordingProblem = last.RecordingProblem;
}

Status StudyTouch::Update(const StudyState& state, const std::vector<SceneContact>& contacts)
{
  return this->IsRunning() ? this->Publish(state, contacts) : Status::Success();
}

WorkspaceFrame StudyTouch::FrameFor(const ScenePlacement& placement, const TouchScene& scene)
{
  if (!this->Automatic)
  {
    this->Automatic = WorkspaceFrame::Around(scene, this->Capabilities());
    this->MovedBefore = this->Session.Moved();
  }
  WorkspaceFrame frame;
  frame.Rotation = placement.AxesFollowCamera ? this->CameraAxes : Matrix3(Matrix3::Identity());
  frame.Scale = placement.Scale.value_or(this->Automatic->Scale);
  frame.CenterWorld = placement.CenterWorld.value_or(this->Automatic->CenterWorld) + this->Moved();
  return frame;
}

Status StudyTouch::Publish(const StudyState& state, const std::vector<SceneContact>& contacts)
{
  Status status = this->PublishAll(state, contacts);
  if (!status.IsOk() && this->IsRunning() && !this->Drilled.Protects(this->Forbidden))
  {
    this->HoldDrill();
  }
  return status;
}

// Keeps the previous scene but disables cutting, since it does not protect all forbidden
// structures.
void StudyTouch::HoldDrill()
{
  TouchScene held = *this->Session.Scene();
  for (std::size_t s = 0; s < held.Structures.size(); ++s)
  {
    held.Structures[s].Drill = {};
    this->Felt.Laws[s] = {};
  }
  this->Session.Loop().LiftPedals();
  // The servo accepted this scene before.
  static_cast<void>(
      this->Session.Publish(std::move(held), this->Session.Frame(), SceneEntry::Continuing));
}

Status StudyTouch::PublishAll(const StudyState& state, const std::vector<SceneContact>& contacts)
{
  try
  {
    Feelable next;
    next.Contacts = contacts;
    TouchScene scene = MakeTouchScene(state, next.Contacts, {}, this->Distances);
    const bool wasHeld = !this->Drilled.Hold().empty();
    this->Drilled.Follow(state, next.Contacts, this->Forbidden);
    this->Drilled.PutInto(scene);
    this->Session.UseEditor(this->Drilled.Editor());
    if (this->IsRunning() && wasHeld != !this->Drilled.Hold().empty())
    {
      // A pedal held in the meantime must not start to cut without a new press.
      this->Session.Loop().LiftPedals();
    }
    next.Tool = state.Tool;
    next.Guides = state.Guides;
    next.Distances = this->Distances;
    next.Held = this->Held;
    next.DrillRevision = this->Drilled.Revision();
    const SceneEntry entry = this->Automatic ? SceneEntry::Continuing : SceneEntry::FadeIn;
    next.Frame = this->FrameFor(state.Placement, scene);
    for (std::size_t s = 0; s < next.Contacts.size(); ++s)
    {
      next.Structures.push_back(*FindStructure(state, next.Contacts[s].Id));
      next.Laws.push_back(scene.Structures[s].Drill);
    }
    this->Felt.Frame = this->Session.Frame(); // the clutch may have moved it
    if (this->Session.Scene() != nullptr && IsSame(next, this->Felt))
    {
      return Status::Success();
    }
    if (this->Held != nullptr)
    {
      scene.Structures.clear();
      scene.Fields = {this->Held};
    }
    std::vector<std::string> advice =
        StiffnessWarnings(scene, this->Capabilities(), this->Settings.Rate);
    const bool keepsTool = !state.Placement.CenterWorld;
    Status status = this->Session.Publish(std::move(scene), next.Frame, entry, keepsTool);
    if (status.IsOk())
    {
      next.Frame = this->Session.Frame();
      this->Advice = std::move(advice);
      this->Felt = std::move(next);
    }
    return status;
  }
  catch (const std::exception& error)
  {
    return Status::Failure(MessageOf(error));
  }
}

void StudyTouch::RunDrill(bool runs)
{
  if (this->IsRunning())
  {
    this->Session.Loop().RunDrill(runs);
  }
}

void StudyTouch::Command(DrillCommand command)
{
  if (this->IsRunning())
  {
    static_cast<void>(this->Session.Loop().Command(command));
  }
}

void StudyTouch::SwitchForcesOff()
{
  if (this->IsRunning())
  {
    this->Session.Loop().SwitchOff();
  }
}

void StudyTouch::SwitchForcesOn()
{
  if (this->IsRunning())
  {
    this->Session.Loop().Rearm();
  }
}

bool StudyTouch::MoveHand(const Vector3& targetWorld)
{
  return this->Session.IsOpen() && this->Session.LeadHand(this->Frame().NearestInReach(
                                       targetWorld, this->Capabilities().Workspace));
}

bool StudyTouch::PlaceHand(const Vector3& towardsViewerWorld)
{
  return this->Session.IsOpen() && this->Session.LeadHand(this->Frame().FirstHand(
                                       towardsViewerWorld, this->Capabilities().Workspace));
}

void StudyTouch::TakeReading(const TouchSessionReading& now)
{
  StudyTouchReading& reading = this->Reading;
  static_cast<TouchSessionReading&>(reading) = now;
  const auto touched = static_cast<std::size_t>(now.Newest.Structure);
  reading.TouchedId = touched < this->Felt.Contacts.size() ? this->Felt.Contacts[touched].Id : 0;
  reading.Safety = now.IsClutched ? "The clutch is held: touch is off, and the tool stays."
                                  : SafetyText(now.Newest);
}

const StudyTouchReading& StudyTouch::Poll()
{
  this->Reading.NewTicks.clear();
  if (!this->IsRunning())
  {
    return this->Reading;
  }
  this->TakeReading(this->Session.Poll());
  this->Reading.DeviceProblem = this->Session.Device().Problem();
  this->Reading.Guidance = this->Session.Device().Guidance();
  this->Reading.Drill =
      this->Drilled.Read(1e-9 * static_cast<double>(this->Time.Now()), this->Reading.Newest);
  const ServoStatistics& statistics = this->Session.Statistics();
  this->Reading.Periods = statistics.Periods;
  this->Reading.Durations = statistics.Durations;
  return this->Reading;
}

Status StudyTouch::StartRecording(const std::filesystem::path& path)
{
  if (!this->IsRunning())
  {
    return Status::Failure("Touch is off: start the touch, then record it.");
  }
  Status status = this->Session.StartRecording(path);
  if (status.IsOk())
  {
    this->RecordedTo = path;
    this->Drilled.FollowNextServo();
  }
  return status;
}
} // namespace palpate
