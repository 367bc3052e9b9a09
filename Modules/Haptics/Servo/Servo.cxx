#include "Servo.h"

#include "ElasticForce.h"
#include "FadingContact.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Normal number of ticks between new samples: a device that is slower than the servo repeats its
// samples, and one with the same rate may occasionally.
int TicksPerSample(const DeviceCapabilities& device, const ServoSettings& settings)
{
  const double least = device.LeastRate();
  const double ticks = least > 0.0 ? std::ceil(settings.Rate / least) : 1.0;
  return ticks >= 1.0 ? static_cast<int>(std::min(ticks, 1000.0)) : 1; // a rate may be NaN here
}

SafetySettings SafetyOf(const DeviceCapabilities& device, const ServoSettings& settings)
{
  SafetySettings safety;
  safety.MaximumForce = device.MaximumForce;
  safety.MaximumTorque = device.MaximumTorque;
  safety.TurnLength = device.TurnLength();
  safety.LargestDamping = device.MaximumDamping;
  safety.DeviceDamping = device.Damping;
  safety.DeviceFriction = device.Friction;
  safety.HasMotors = device.HasMotors;
  safety.RampDuration = settings.RampDuration;
  safety.MaximumSlew = settings.MaximumSlew;
  safety.Limits.StaleTicks = 1 + TicksPerSample(device, settings);
  return safety;
}
} // namespace

Servo::Servo(HapticDevice& device, const ServoSettings& settings)
    : Recorded(settings.RecordedTicks), Device(device), Settings(settings),
      HandVelocity(settings.VelocityTimeConstant), MostForce(device.Capabilities().MaximumForce),
      TurnLength(device.Capabilities().TurnLength()),
      Safety(SafetyOf(device.Capabilities(), settings)),
      Carrying(device.Capabilities().GravityCompensation),
      MostUntaken(TicksPerSample(device.Capabilities(), settings) - 1),
      ClutchButtons(settings.ClutchButtons)
{
}

Status Servo::Publish(std::shared_ptr<const TouchScene> scene, SceneEntry entry)
{
  std::unique_ptr<ServoScene> next;
  Status status = ServoScene::Make(std::move(scene), this->Settings.VelocityTimeConstant, next,
                                   this->TurnLength);
  if (status.IsOk())
  {
    next->SetEntry(entry);
    this->Scenes.Publish(std::move(next));
  }
  return status;
}

void Servo::Tick(const TickInfo& tick) noexcept
{
  const TickObservation now = this->Observe(tick);
  const Change change = this->TakeOver(now);
  this->TickTime = 1e-9 * static_cast<double>(tick.Started);
  if (now.State == DeviceState::Ready && now.HasSample)
  {
    this->Feel(now);
  }
  const Vector3 force = this->Safety.Apply(this->InputOf(now));
  const bool isTaken = this->Send(force, this->Safety.Torque());
  this->OrderCuts();
  TouchState state = this->StateOf(now, force);
  state.WasTaken = isTaken;
  state.WasRearmed = change.IsRearmed;
  state.WasContinued = change.IsContinued;
  state.Command = change.Command;
  state.Safety = this->Safety.Report();
  this->Device.Show(state);
  this->Newest.Publish(state);
  this->Recorded.Push(state);
}

bool Servo::StaysOff() const noexcept
{
  const SafetyReport& safety = this->Safety.Report();
  return this->OffWanted.load(std::memory_order_acquire) ||
         (safety.Fault != SafetyFault::None && !safety.WillResume);
}

void Servo::Resume() noexcept
{
  this->Safety.Resume();
  this->ForgetMotion();
  this->ReleasePedal();
}

Servo::Change Servo::TakeOver(const TickObservation& now) noexcept
{
  Change change;
  change.IsRearmed = this->RearmWanted.exchange(false, std::memory_order_acq_rel);
  if (change.IsRearmed)
  {
    this->Safety.Rearm();
    this->ForgetMotion();
  }
  // After Rearm: if both were requested, forces stay off.
  if (this->OffWanted.exchange(false, std::memory_order_acq_rel))
  {
    this->Safety.Fail(SafetyFault::SwitchedOff);
  }
  // Before the scene: what was published before the release is then known.
  const bool isReleased = this->UnclutchWanted.exchange(false, std::memory_order_acq_rel);
  change.IsContinued = this->TakeOverScene();
  this->TakeClutch(now, isReleased);
  // After the scene: a request made before it was published applies to it.
  if (this->LiftWanted.exchange(false, std::memory_order_acq_rel))
  {
    this->ReleaseButton();
  }
  const bool wasDrilling = this->IsDrilling;
  this->IsDrilling = this->IsPedalDown(now);
  change.Command = this->TakeCommand(wasDrilling && !this->IsDrilling);
  return change;
}

// While the clutch is held nothing is followed, so that the tool is placed where it returns.
void Servo::TakeClutch(const TickObservation& now, bool isReleased) noexcept
{
  const bool isKnown = now.State == DeviceState::Ready && now.HasSample;
  const std::uint32_t buttons = this->ClutchButtons.load(std::memory_order_acquire);
  const bool isDown = isKnown && (now.Sample.Buttons & buttons) != 0;
  const bool isHeld = this->ClutchWanted.exchange(false, std::memory_order_acq_rel) || isDown;
  const bool was = this->IsClutched;
  this->IsClutched = isHeld || (was && !isReleased);
  if (this->IsClutched != was)
  {
    this->ForgetMotion();
    this->Current.Felt = ServoScene::Feeling();
  }
}

// Before a device is ready its buttons are not valid.
bool Servo::IsPedalDown(const TickObservation& now) noexcept
{
  const bool isKnown = now.State == DeviceState::Ready && now.HasSample;
  const bool isDown = !isKnown || (now.Sample.Buttons & this->Settings.PedalButtons) != 0;
  this->IsButtonPedal = isKnown && isDown && (this->IsButtonPedal || !this->WasButtonDown);
  this->WasButtonDown = isDown;
  return this->IsButtonPedal || this->Pedal.load(std::memory_order_acquire);
}

// It must be pressed again.
void Servo::ReleaseButton() noexcept
{
  this->IsButtonPedal = false;
  this->WasButtonDown = true;
}

// Both pedals must be pressed again.
void Servo::ReleasePedal() noexcept
{
  this->ReleaseButton();
  this->Pedal.store(false, std::memory_order_release);
}

// A stroke ends with the pedal; other commands then wait for the next tick.
DrillCommand Servo::TakeCommand(bool endsStroke) noexcept
{
  ServoScene* const scene = this->Scenes.Current();
  DrillLink* const link = scene != nullptr ? scene->Scene().Drill.Link.get() : nullptr;
  CutOrder order;
  order.Command = endsStroke ? DrillCommand::EndStroke : DrillCommand::None;
  if ((!endsStroke && !this->Commands.Pop(order.Command)) || link == nullptr)
  {
    return DrillCommand::None;
  }
  scene->LiftDrill();
  order.Number = this->OrderCount;
  if (!link->Orders.Push(order))
  {
    return DrillCommand::None;
  }
  ++this->OrderCount;
  return order.Command;
}

// None after a fault, until the pedal is pressed again.
void Servo::OrderCuts() noexcept
{
  const bool isAllowed = this->Safety.Report().Fault == SafetyFault::None;
  if (!isAllowed)
  {
    this->ReleasePedal();
  }
  ServoScene* const scene = this->Scenes.Current();
  if (scene != nullptr)
  {
    isAllowed ? scene->OrderCuts(this->OrderCount) : scene->LiftDrill();
  }
}

// Returns whether it continues the previous one. A continuing scene that was not yet followed is
// not continued itself.
bool Servo::TakeOverScene() noexcept
{
  if (this->CarriesOn)
  {
    return false;
  }
  bool carriesOn = false;
  const bool isNew = this->Scenes.Refresh(
      [&](const ServoScene* last, ServoScene& next)
      {
        carriesOn = next.Entry() == SceneEntry::Continuing && last != nullptr && this->HasFelt;
        if (carriesOn)
        {
          next.CarryOn(*last);
          int& touched = this->Current.Felt.Structure;
          touched = next.IndexOf(*last, touched);
        }
      });
  if (carriesOn)
  {
    this->CarriesOn = true;
    this->TicksSinceModel = this->Settings.ModelInterval;
  }
  else if (isNew)
  {
    this->Safety.FadeIn();
    this->ForgetMotion();
  }
  this->SceneCount += isNew ? 1 : 0;
  return carriesOn;
}

void Servo::ForgetMotion() noexcept
{
  this->HasFelt = false;
  this->CarriesOn = false;
  this->HandVelocity.Reset();
  this->Turning.Reset();
  if (this->Scenes.Current() != nullptr)
  {
    this->Scenes.Current()->Leave();
  }
}

TickObservation Servo::Observe(const TickInfo& tick) noexcept
{
  TickObservation now;
  now.Tick = tick;
  now.HasSample = this->Device.Read(now.Sample);
  now.State = this->Device.State();
  return now;
}

FollowStep Servo::StepTo(const DeviceSample& sample, double passed) noexcept
{
  FollowStep step;
  step.Now = this->Current.Pose;
  step.Last = this->HasFelt ? this->LastAsked : step.Now;
  step.Passed = passed;
  step.IsDrilling = this->IsDrilling;
  step.Time = this->TickTime;
  step.MostPush = this->MostForce;
  step.Hand = sample.Position;
  step.HandVelocity = this->HandVelocity.Update(step.Hand, passed);
  step.IsPlaced = this->CarriesOn || !this->HasFelt;
  this->CarriesOn = false;
  const int interval = std::max(this->Settings.ModelInterval, 1);
  this->TicksSinceModel = this->HasFelt ? this->TicksSinceModel + 1 : interval;
  step.AsksModel = this->TicksSinceModel >= interval;
  step.ModelPeriod = interval > 1 ? interval / this->Settings.Rate : 0.0;
  if (step.AsksModel)
  {
    this->TicksSinceModel = 0;
    this->LastAsked = step.Now;
  }
  return step;
}

void Servo::Feel(const TickObservation& now) noexcept
{
  ServoScene* const scene = this->Scenes.Current();
  const bool isNew = !this->HasFelt || now.Sample.Sequence != this->LastFelt.Sequence;
  // The watchdog will detect a pose that is none; no model is queried for it.
  if (scene == nullptr || !isNew || !now.Sample.IsPose())
  {
    return;
  }
  const double passed =
      this->HasFelt ? 1e-9 * static_cast<double>(now.Sample.Time - this->LastFelt.Time) : 0.0;
  DeviceSample limited = now.Sample;
  this->Turning.Follow(passed, limited.Orientation);
  this->Current.Pose = scene->Scene().Frame.PoseWorld(limited);
  if (this->IsClutched)
  {
    this->Current.Felt.Deepest.ProxyWorld = this->Current.Pose.PositionWorld;
    this->Current.Felt.ProxyOrientation = this->Current.Pose.Orientation;
    return;
  }
  this->Current.Felt = scene->Follow(this->StepTo(now.Sample, passed));
  this->LastFelt = now.Sample;
  this->HasFelt = true;
}

SafetyInput Servo::InputOf(const TickObservation& now) const noexcept
{
  SafetyInput input;
  input.Observed = now;
  input.SceneFault = this->Current.Felt.IsValid ? SafetyFault::None : SafetyFault::InvalidContact;
  input.IsTouching = this->Current.Felt.Structure >= 0;
  input.ContactForce = this->Current.Felt.Force;
  input.ContactTorque = this->Current.Felt.Torque;
  input.AmbientForce = this->Carrying + this->Current.Felt.Field;
  return input;
}

bool Servo::Send(const Vector3& force, const Vector3& torque) noexcept
{
  const bool isTaken = this->Device.ApplyWrench(force, torque);
  const bool isReady = this->Device.State() == DeviceState::Ready;
  this->UntakenTicks = isReady && !isTaken ? this->UntakenTicks + 1 : 0;
  if (this->UntakenTicks > this->MostUntaken)
  {
    this->Safety.Fail(SafetyFault::UntakenForce);
  }
  return isTaken;
}

TouchState Servo::StateOf(const TickObservation& now, const Vector3& force) noexcept
{
  TouchState state;
  state.Tick = now.Tick;
  state.State = now.State;
  state.HasSample = now.HasSample;
  state.Sample = now.Sample;
  state.ProbeWorld = this->Current.Pose.PositionWorld;
  state.ProxyWorld = this->Current.Felt.Deepest.ProxyWorld;
  Eigen::Map<Eigen::Vector4d>(state.ProbeOrientation.data()) =
      this->Current.Pose.Orientation.coeffs();
  Eigen::Map<Eigen::Vector4d>(state.ProxyOrientation.data()) =
      this->Current.Felt.ProxyOrientation.coeffs();
  state.ForceDevice = force;
  state.TorqueDevice = this->Safety.Torque();
  ServoScene* const scene = this->Scenes.Current();
  state.ForceWorld = scene != nullptr ? scene->Scene().Frame.TurnedToWorld(force) : force;
  state.Structure = this->Current.Felt.Structure;
  state.Depth = this->Current.Felt.Deepest.Depth;
  state.HasFoot = state.Structure >= 0 && this->Current.Felt.Deepest.HasFoot;
  if (state.HasFoot)
  {
    state.FootWorld = this->Current.Felt.Deepest.FootWorld;
  }
  const ElasticForce* const elastic = this->Current.Felt.Deepest.Elastic;
  if (state.Structure >= 0 && elastic != nullptr)
  {
    state.PatchRadius = elastic->PatchRadius;
    state.ElasticEnergy = elastic->Energy;
    state.IsBeyondLinear = !elastic->IsValid;
  }
  state.Scene = this->SceneCount;
  state.IsClutched = this->IsClutched;
  state.IsBuried = this->Current.Felt.IsBuried;
  state.IsBehind = this->Current.Felt.IsBehind;
  state.IsDrilling = this->IsDrilling;
  state.DrillVersion = scene != nullptr ? scene->VersionNumber() : 0;
  state.DrillOrders = this->OrderCount;
  return state;
}
} // namespace palpate
