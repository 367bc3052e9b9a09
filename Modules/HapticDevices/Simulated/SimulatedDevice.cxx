#include "SimulatedDevice.h"

#include "ClampedLength.h"
#include "TurnBetween.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr std::int64_t LongestStep = 10'000;    // ns
constexpr std::int64_t ForceLapse = 20'000'000; // ns
constexpr std::int64_t Lateness = 20'000'000;   // ns
constexpr double HomingError = 17.0;            // mm

DeviceCapabilities CapabilitiesOf(const SimulatedSettings& settings)
{
  DeviceCapabilities c;
  c.Name = "Simulated device";
  const Vector3 corner = Vector3::Constant(settings.WorkspaceRadius);
  c.Workspace = {-corner, corner};
  c.DegreesOfFreedom = settings.MaximumTorque > 0.0 ? 6 : 3;
  c.MaximumForce = settings.MaximumForce;
  c.MaximumTorque = settings.MaximumTorque;
  c.MaximumStiffness = settings.MaximumStiffness;
  c.MaximumDamping = settings.MaximumDamping;
  c.Damping = settings.Hand.Damping;
  c.Friction = settings.Hand.Friction;
  c.Resolution = settings.Resolution;
  c.Delay = settings.Delay;
  c.Rate = settings.Rate;
  c.HasMotors = settings.HasMotors;
  return c;
}

std::int64_t Nanoseconds(double seconds) noexcept
{
  return static_cast<std::int64_t>(std::llround(1e9 * seconds));
}
} // namespace

SimulatedDevice::SimulatedDevice(Clock& clock, const SimulatedSettings& settings)
    : Time(clock), Settings(settings), Abilities(CapabilitiesOf(settings)),
      Body(settings.Hand, Vector3::Zero()), Joint(settings.Wrist, Eigen::Quaterniond::Identity())
{
}

std::string SimulatedDevice::Problem() const
{
  return this->State() == DeviceState::Error ? "The simulated device was unplugged." : "";
}

Status SimulatedDevice::Open()
{
  if (this->State() != DeviceState::Closed)
  {
    return Status::Failure("The simulated device is open already.");
  }
  this->Opened = this->Time.Now();
  this->Reached = this->Opened;
  this->Target = this->TargetAt(this->Opened);
  this->Body = SimulatedHand(this->Settings.Hand, this->Target);
  this->TurnTarget = this->TurnTargetAt(this->Opened);
  this->Joint = SimulatedWrist(this->Settings.Wrist, this->TurnTarget);
  this->ForgetCommands();
  this->Life = this->Settings.HomingDuration > 0.0 ? DeviceState::Homing : DeviceState::Ready;
  return Status::Success();
}

void SimulatedDevice::Close() noexcept
{
  this->ForgetCommands();
  this->Life = DeviceState::Closed;
}

void SimulatedDevice::ForgetCommands() noexcept
{
  this->CommandCount = 0;
  this->InEffect = {};
}

Vector3 SimulatedDevice::TargetAt(std::int64_t time) noexcept
{
  return this->Settings.Path != nullptr
             ? this->Settings.Path(1e-9 * static_cast<double>(time - this->Opened))
             : Vector3(this->Wanted.Latest());
}

Eigen::Quaterniond SimulatedDevice::TurnTargetAt(std::int64_t time) const
{
  return this->Settings.TurnPath != nullptr
             ? this->Settings.TurnPath(1e-9 * static_cast<double>(time - this->Opened))
             : Eigen::Quaterniond::Identity();
}

const SimulatedDevice::Command& SimulatedDevice::CommandAt(std::int64_t time) noexcept
{
  while (this->CommandCount > 0 && this->Commands[this->Oldest].Time <= time)
  {
    this->InEffect = this->Commands[this->Oldest];
    this->Oldest = (this->Oldest + 1) % this->Commands.size();
    --this->CommandCount;
  }
  if (time - this->InEffect.Time > ForceLapse)
  {
    this->InEffect.Force.setZero();
    this->InEffect.Torque.setZero();
  }
  return this->InEffect;
}

void SimulatedDevice::AdvanceTo(std::int64_t now) noexcept
{
  const std::int64_t duration = now - this->Reached;
  if (duration <= 0)
  {
    return;
  }
  const std::int64_t steps = (duration + LongestStep - 1) / LongestStep;
  const double step = 1e-9 * static_cast<double>(duration) / static_cast<double>(steps);
  const Vector3 end = this->TargetAt(now);
  const Vector3 increment = (end - this->Target) / static_cast<double>(steps);
  const Eigen::Quaterniond endTurn = this->TurnTargetAt(now);
  const Vector3 turn = TurnBetween(this->TurnTarget, endTurn) / static_cast<double>(steps);
  for (std::int64_t i = 0; i < steps; ++i)
  {
    const Command& command = this->CommandAt(this->Reached + i * duration / steps);
    this->Body.Advance(this->Target + static_cast<double>(i) * increment, increment / step,
                       command.Force, step);
    if (this->Turns())
    {
      this->Joint.Advance(TurnedBy(static_cast<double>(i) * turn, this->TurnTarget), turn / step,
                          command.Torque, step);
    }
  }
  this->Target = end;
  this->TurnTarget = endTurn;
  this->Reached = now;
}

Vector3 SimulatedDevice::Counted() const noexcept
{
  const double count = this->Settings.Resolution;
  const Vector3& position = this->Body.Position();
  return count > 0.0 ? Vector3((position / count).array().round() * count) : position;
}

void SimulatedDevice::Measure(std::int64_t now, SimulatedFault fault) noexcept
{
  Vector3 position = this->Counted();
  if (now - this->Opened >= Nanoseconds(this->Settings.HomingDuration))
  {
    this->Life = DeviceState::Ready;
  }
  else
  {
    position[0] += HomingError;
  }
  if (fault == SimulatedFault::NonFinitePosition)
  {
    position[1] = std::numeric_limits<double>::quiet_NaN();
  }
  ++this->Last.Sequence;
  this->Last.Time = fault == SimulatedFault::LateSamples ? now - Lateness : now;
  Eigen::Map<Eigen::Vector4d>(this->Last.Orientation.data()) = this->Joint.Orientation().coeffs();
  this->Last.Position = fault == SimulatedFault::MirroredPosition ? Vector3(-position) : position;
}

bool SimulatedDevice::Read(DeviceSample& sample) noexcept
{
  const SimulatedFault fault = this->Broken;
  if (fault == SimulatedFault::Unplugged && this->State() != DeviceState::Closed)
  {
    this->Life = DeviceState::Error;
  }
  if (this->State() == DeviceState::Closed || this->State() == DeviceState::Error)
  {
    return false;
  }
  const std::int64_t now = this->Time.Now();
  this->AdvanceTo(now);
  if (fault != SimulatedFault::FrozenSample)
  {
    this->Measure(now, fault);
  }
  sample = this->Last;
  return true;
}

bool SimulatedDevice::ApplyWrench(const Vector3& force, const Vector3& torque) noexcept
{
  const DeviceState state = this->State();
  if (state == DeviceState::Closed || state == DeviceState::Error ||
      this->Broken.load() == SimulatedFault::RefusedForce)
  {
    return false;
  }
  if (this->CommandCount == this->Commands.size())
  {
    this->Oldest = (this->Oldest + 1) % this->Commands.size();
    --this->CommandCount;
  }
  Command& command = this->Commands[(this->Oldest + this->CommandCount) % this->Commands.size()];
  ++this->CommandCount;
  command.Time = this->Time.Now() + Nanoseconds(this->Settings.Delay);
  const bool isReady = state == DeviceState::Ready;
  command.Force = isReady ? ClampedLength(force, this->Settings.MaximumForce) : Vector3::Zero();
  command.Torque = isReady ? ClampedLength(torque, this->Settings.MaximumTorque) : Vector3::Zero();
  return true;
}

Status RegisterSimulatedDevices(DeviceRegistry& registry)
{
  return registry.Add("simulated", "a computed device with a hand on it, to be moved by a program",
                      [](Clock& clock, const std::string&, std::unique_ptr<HapticDevice>& device)
                      {
                        device = std::make_unique<SimulatedDevice>(clock, SimulatedSettings());
                        return Status::Success();
                      });
}
} // namespace palpate
