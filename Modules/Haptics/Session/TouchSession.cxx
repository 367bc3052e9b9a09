#include "TouchSession.h"

#include "DrillEditor.h"
#include "FieldSolid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
TouchSession::TouchSession(Clock& clock, const RealtimeRequest& request)
    : Time(clock), Request(request)
{
}

void TouchSession::Open(std::unique_ptr<HapticDevice> opened, const ServoSettings& settings)
{
  this->Stop();
  this->Settings = settings;
  this->Settings.ClutchButtons = this->ClutchButton >= 0 ? 1U << this->ClutchButton : 0U;
  this->Opened = std::move(opened);
  this->End = std::make_unique<EndBeforeExit>([this] { this->Stop(); });
  this->Current.reset();
  this->Place = {};
  this->Clutch = {};
  this->AllMoved.setZero();
  this->Hand.setZero();
  this->Watch = {};
  this->Reading = {};
}

Status TouchSession::Begin(TouchScene scene, const WorkspaceFrame& frame)
{
  this->MakeServo();
  Status status = this->Publish(std::move(scene), frame, SceneEntry::FadeIn);
  if (!status.IsOk())
  {
    this->Thread.reset();
  }
  return status;
}

Status TouchSession::Start(TouchScene scene, const WorkspaceFrame& frame, bool staysOff)
{
  Status status = this->Begin(std::move(scene), frame);
  if (status.IsOk() && staysOff)
  {
    this->Loop().SwitchOff();
  }
  return status.IsOk() ? this->Run() : status;
}

void TouchSession::SetClutchButton(int button)
{
  if (button == this->ClutchButton)
  {
    return;
  }
  this->ClutchButton = button;
  this->Settings.ClutchButtons = button >= 0 ? 1U << button : 0U;
  if (this->IsRunning())
  {
    this->Loop().SetClutchButtons(this->Settings.ClutchButtons);
    this->HoldClutch(false, this->Loop().Latest());
  }
}

// A servo numbers its orders and ticks from 0.
void TouchSession::MakeServo()
{
  if (this->Editor != nullptr)
  {
    this->Editor->ForNextServo();
  }
  if (this->Press.IsWaiting())
  {
    this->Press.Await(this->Press.Rest(), 0);
  }
  this->Thread = std::make_unique<ServoThread>(*this->Opened, this->Time, this->Settings);
}

Status TouchSession::Run()
{
  this->Drill.Start(this->Editor);
  return this->Thread->Start(this->Request);
}

void TouchSession::Pause()
{
  if (this->IsRunning())
  {
    this->Thread->Stop();
    this->Drill.Stop();
  }
}

void TouchSession::Stop()
{
  this->Pause();
  if (this->IsOpen())
  {
    this->Opened->Close();
  }
  if (this->IsRecording())
  {
    this->Reading.RecordingProblem = this->StopRecording().Message();
  }
  this->Thread.reset();
  this->Opened.reset();
  this->End.reset();
}

// mm; zero without contact.
Vector3 TouchSession::ShiftThatKeepsTool(const WorkspaceFrame& frame)
{
  const bool isNew = frame.Scale != this->Place.Scale || frame.Rotation != this->Place.Rotation;
  if (!isNew || !this->IsRunning() || this->Loop().Latest().Structure < 0)
  {
    return Vector3::Zero();
  }
  const Vector3 hand = this->Loop().Latest().Sample.Position;
  return this->Place.ToWorld(hand) - frame.ToWorld(hand);
}

Status TouchSession::Publish(TouchScene scene, WorkspaceFrame frame, SceneEntry entry,
                             bool keepsTool)
{
  const Vector3 shift = keepsTool ? this->ShiftThatKeepsTool(frame) : Vector3::Zero();
  frame.CenterWorld += shift;
  auto next = std::make_shared<TouchScene>(std::move(scene));
  next->Frame = frame.ForDevice();
  Status status = next->Check();
  if (status.IsOk() && this->IsRunning())
  {
    status = this->Loop().Publish(next, entry);
  }
  if (status.IsOk())
  {
    this->Current = std::move(next);
    this->Place = frame;
    this->AllMoved += shift;
  }
  return status;
}

void TouchSession::UseEditor(std::shared_ptr<DrillEditor> editor)
{
  if (editor == this->Editor)
  {
    return;
  }
  this->Drill.Stop();
  this->Editor = std::move(editor);
  if (this->IsRunning())
  {
    this->Drill.Start(this->Editor);
  }
}

bool TouchSession::LeadHand(const Vector3& handDevice)
{
  const Vector3& goal = this->Press.IsWaiting() ? this->Press.Rest() : handDevice;
  const bool isLed = this->IsOpen() && this->Opened->LeadHand(goal);
  this->Hand = isLed ? handDevice : this->Hand;
  return isLed;
}

// The ray goes through the current scene, and through what drilling has left of it.
void TouchSession::AimThroughScene()
{
  if (!this->Ray || this->Ray->Touched() != this->Current)
  {
    this->Ray.emplace(this->Current);
    this->RayNumber = 0;
  }
  if (this->Editor == nullptr)
  {
    return;
  }
  const DrillReading drilled = this->Editor->Newest();
  if (drilled.Number == this->RayNumber)
  {
    return;
  }
  std::vector<std::shared_ptr<const FieldSolid>> solids(drilled.Fields.size());
  for (const TouchStructure& structure : this->Current->Structures)
  {
    const auto site = static_cast<std::size_t>(structure.Site);
    if (structure.Site >= 0 && site < solids.size())
    {
      const int material = this->Editor->Site(structure.Site).Material();
      static_cast<void>(FieldSolid::Make(drilled.Fields[site], material,
                                         structure.Model->BoundsWorld(), solids[site]));
    }
  }
  this->Ray->UseSolids(std::move(solids));
  this->RayNumber = drilled.Number;
}

std::optional<TouchRay::Rest> TouchSession::RestBetween(const Vector3& from, const Vector3& to)
{
  if (this->Current == nullptr)
  {
    return std::nullopt;
  }
  this->AimThroughScene();
  std::optional<TouchRay::Rest> rest = this->Ray->First(from, to);
  if (rest)
  {
    rest->ToolWorld += this->Place.Scale * HandPress::Hover * rest->NormalWorld;
  }
  return rest;
}

std::optional<TouchRay::Rest> TouchSession::RestInPlane(const Vector3& point, const Vector3& right,
                                                        const Vector3& up, double reach)
{
  constexpr int Lines = 32;
  if (this->Current == nullptr || this->Current->Structures.empty())
  {
    return std::nullopt;
  }
  const Eigen::AlignedBox3d bounds = this->Current->BoundsWorld();
  const double far = bounds.diagonal().norm() + (point - bounds.center()).norm();
  std::optional<TouchRay::Rest> inwards;
  std::optional<TouchRay::Rest> ahead;
  double toInwards = std::numeric_limits<double>::infinity();
  double toAhead = reach;
  bool isFree = false;
  for (int line = 0; line < Lines; ++line)
  {
    const double angle = 2.0 * M_PI * line / Lines;
    const Vector3 direction = std::cos(angle) * right + std::sin(angle) * up;
    const auto from = this->RestBetween(point + far * direction, point);
    isFree = isFree || !from;
    if (from && (from->ToolWorld - point).norm() < toInwards)
    {
      toInwards = (from->ToolWorld - point).norm();
      inwards = from;
    }
    const auto met = this->RestBetween(point, point + reach * direction);
    if (met && (met->ToolWorld - point).norm() < toAhead)
    {
      toAhead = (met->ToolWorld - point).norm();
      ahead = TouchRay::Rest{point, met->NormalWorld, met->Structure};
    }
  }
  return isFree ? ahead : inwards;
}

bool TouchSession::HasRestAround(const Vector3& point, const Vector3& right, const Vector3& up,
                                 double reach)
{
  constexpr int Places = 8;
  if (this->Current == nullptr)
  {
    return false;
  }
  this->AimThroughScene();
  bool isFree = this->Ray->IsFree(point);
  for (int place = 0; isFree && place < Places; ++place)
  {
    const double angle = 2.0 * M_PI * place / Places;
    isFree = this->Ray->IsFree(point + reach * (std::cos(angle) * right + std::sin(angle) * up));
  }
  return !isFree;
}

void TouchSession::LiftHand()
{
  this->Press.GiveUp();
  if (this->IsRunning())
  {
    this->Loop().HoldClutch();
  }
}

void TouchSession::PressHand()
{
  this->Press.Await(this->Hand, this->IsRunning() ? this->Loop().Latest().Tick.Number : 0);
}

double TouchSession::PushFor(double force, int structure) const
{
  const TouchStructure& touched = this->Current->Structures[static_cast<std::size_t>(structure)];
  const double own = touched.Model->OwnStiffness(this->Current->Tool);
  const double stiffness = own > 0.0 ? own * this->Place.Scale : touched.Law.Stiffness;
  constexpr double OfHand = 0.5;   // N/mm
  constexpr double Deepest = 25.0; // mm of the hand
  const double depth = force * (1.0 / OfHand + (stiffness > 0.0 ? 1.0 / stiffness : 0.0));
  return this->Place.Scale * (HandPress::Hover + std::min(depth, Deepest));
}

void TouchSession::HoldClutch(bool isHeld, const TouchState& now)
{
  if (isHeld == this->Clutch.IsHeld())
  {
    return;
  }
  if (isHeld)
  {
    this->Clutch.Hold(now.ProbeWorld); // the servo's own clutch has ended all forces
    return;
  }
  const WorkspaceFrame moved = this->Clutch.Release(this->Place, now.Sample.Position);
  this->AllMoved += moved.CenterWorld - this->Place.CenterWorld;
  this->Place = moved;
  auto scene = std::make_shared<TouchScene>(*this->Current);
  scene->Frame = moved.ForDevice();
  this->Current = std::move(scene);
  // The servo has accepted this scene before.
  static_cast<void>(this->Loop().Publish(this->Current, SceneEntry::FadeIn));
  this->Loop().ReleaseClutch();
}

void TouchSession::TakeTicks()
{
  using Kind = TouchChange::Kind;
  const std::size_t known = this->Reading.Changes.size();
  for (TouchState state; this->Loop().PopRecorded(state);)
  {
    this->Reading.NewTicks.push_back(state);
    this->Watch.Take(state, this->Reading.Changes);
    if (this->Press.Take(state))
    {
      this->Loop().ReleaseClutch();
      static_cast<void>(this->Opened->LeadHand(this->Hand));
    }
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
  for (std::size_t n = known; n < this->Reading.Changes.size(); ++n)
  {
    const TouchChange change = this->Reading.Changes[n];
    const bool isPress = change.What == Kind::ButtonPressed;
    if ((isPress || change.What == Kind::ButtonReleased) && change.Button == this->ClutchButton)
    {
      this->HoldClutch(isPress, this->Reading.NewTicks.back());
    }
  }
}

const TouchSessionReading& TouchSession::Poll()
{
  this->Reading.NewTicks.clear();
  this->Reading.Changes.clear();
  if (!this->IsRunning())
  {
    return this->Reading;
  }
  this->TakeTicks();
  this->Loop().Reclaim();
  this->Reading.Newest = this->Loop().Latest();
  this->Reading.LostTicks = this->Loop().LostTicks();
  this->Reading.IsClutched = this->Clutch.IsHeld();
  if (this->Reading.IsClutched)
  {
    this->Reading.Newest.ProbeWorld = this->Clutch.PlaceWorld();
    this->Reading.Newest.ProxyWorld = this->Clutch.PlaceWorld();
  }
  return this->Reading;
}

Status TouchSession::StartRecording(const std::filesystem::path& path,
                                    BackgroundWriter::Limits limits)
{
  if (!this->IsOpen())
  {
    return Status::Failure("Touch is off: start it before recording.");
  }
  if (this->IsRecording())
  {
    return Status::Failure("A recording is already running.");
  }
  auto recorder = std::make_unique<TouchRecorder>(limits);
  Status status = recorder->Start(path.string(), {this->Settings, this->Opened->Capabilities()});
  if (!status.IsOk())
  {
    return status;
  }
  this->Reading.RecordedTicks = 0;
  this->Reading.RecordingProblem.clear();
  if (this->IsRunning())
  {
    this->Pause();
    this->TakeTicks();
    const bool staysOff = this->Loop().StaysOff();
    this->MakeServo();
    if (staysOff)
    {
      this->Loop().SwitchOff();
    }
    status = this->Loop().Publish(this->Current, SceneEntry::FadeIn);
    status = status.IsOk() ? this->Run() : status;
  }
  this->Recorder = std::move(recorder);
  if (!status.IsOk())
  {
    this->Stop();
  }
  return status;
}

Status TouchSession::StopRecording()
{
  if (!this->IsRecording())
  {
    return Status::Failure("No recording is running.");
  }
  if (this->IsRunning())
  {
    this->TakeTicks();
  }
  if (!this->IsRecording())
  {
    return Status::Failure(this->Reading.RecordingProblem);
  }
  Status status = this->Recorder->Finish();
  this->Recorder.reset();
  return status;
}
} // namespace palpate
