#include "SafetyChain.h"

#include "TurnBetween.h"

namespace palpate
{
namespace
{
// s. The filter's gain is at most 1, so no more is credited than was absorbed.
constexpr double MotionTimeConstant = 0.003;
} // namespace

SafetyChain::SafetyChain(const SafetySettings& settings) noexcept
    : Dog(settings.Limits), Recovery(settings.HasMotors), Ramp(settings.RampDuration),
      Energy(settings.LargestDamping, settings.TurnLength), Limit(settings.MaximumForce),
      Slew(settings.MaximumSlew), TorqueLimit(settings.MaximumTorque),
      TorqueSlew(settings.MaximumSlew * settings.TurnLength), Motion(MotionTimeConstant),
      Turning(MotionTimeConstant), TurnLength(settings.TurnLength),
      DeviceDamping(settings.DeviceDamping), DeviceFriction(settings.DeviceFriction)
{
}

SafetyFault SafetyChain::FaultOf(const SafetyInput& input) noexcept
{
  const SafetyFault observed = this->Dog.Check(input.Observed);
  return observed != SafetyFault::None ? observed : input.SceneFault;
}

double SafetyChain::PeriodBefore(const TickObservation& now) const noexcept
{
  return this->HasLast ? 1e-9 * static_cast<double>(now.Tick.Started - this->Last.Tick.Started)
                       : 0.0;
}

// Turns are not looked at where no torque is shown.
Twist SafetyChain::PathBefore(const TickObservation& now) const noexcept
{
  Twist path;
  if (this->HasLast)
  {
    path.Shift = Vector3(now.Sample.Position) - Vector3(this->Last.Sample.Position);
  }
  if (this->HasLast && this->TurnLength > 0.0)
  {
    const Eigen::Map<const Eigen::Quaterniond> before(this->Last.Sample.Orientation.data());
    const Eigen::Map<const Eigen::Quaterniond> after(now.Sample.Orientation.data());
    path.Turn = TurnBetween(before, after);
  }
  return path;
}

void SafetyChain::KeepBooks(const TickObservation& now, const Twist& path, double period) noexcept
{
  const double speed = this->Motion.Update(now.Sample.Position, period).norm();
  this->Turned += path.Turn;
  const double turning = this->TurnLength * this->Turning.Update(this->Turned, period).norm();
  this->Energy.Account({this->AppliedContact, this->AppliedTorque}, path);
  this->Energy.Credit((this->DeviceDamping * speed + this->DeviceFriction) * speed * period);
  this->Energy.Credit(this->DeviceDamping * turning * turning * period);
}

Vector3 SafetyChain::Zero() noexcept
{
  this->Motion.Reset();
  this->Turning.Reset();
  this->Turned.setZero();
  this->HasLast = false;
  this->AppliedContact.setZero();
  this->AppliedTorque.setZero();
  this->Energy.Close();
  this->Slew.Reset();
  this->TorqueSlew.Reset();
  this->Ramp.Restart();
  return Vector3::Zero();
}

void SafetyChain::Fail(SafetyFault fault) noexcept
{
  this->Recovery.Restart();
  const bool endsByItself = this->Recovery.EndsByItself(fault);
  if (this->LastReport.Fault == SafetyFault::None || (this->LastReport.WillResume && !endsByItself))
  {
    this->LastReport = {};
    this->LastReport.Fault = fault;
    this->LastReport.WillResume = endsByItself;
  }
}

void SafetyChain::Rearm() noexcept
{
  this->LastReport = {};
  this->Guard.Reset();
  this->Resume();
}

void SafetyChain::Resume() noexcept
{
  this->Dog.Reset();
  this->Recovery.Restart();
  this->Zero();
}

void SafetyChain::FadeIn() noexcept
{
  this->Ramp.Restart();
}

// A fault that lasts is not looked at again: only Rearm ends it.
void SafetyChain::Judge(const SafetyInput& input) noexcept
{
  if (this->LastReport.Fault != SafetyFault::None && !this->LastReport.WillResume)
  {
    return;
  }
  const SafetyFault fault = this->FaultOf(input);
  if (fault != SafetyFault::None)
  {
    this->Fail(fault);
  }
  else if (!this->LastReport.WillResume || this->Recovery.IsOver(input.Observed.Tick.Started))
  {
    this->LastReport = {};
  }
}

Vector3 SafetyChain::Apply(const SafetyInput& input) noexcept
{
  this->Judge(input);
  const bool isReady = input.Observed.State == DeviceState::Ready;
  if (this->LastReport.Fault != SafetyFault::None || !isReady)
  {
    this->LastReport.IsArmed = false;
    return this->Zero();
  }
  Vector3 force = this->Shape(input);
  if (this->Guard.HasTripped())
  {
    this->Fail(SafetyFault::NonFiniteForce);
    return this->Zero();
  }
  this->Last = input.Observed;
  this->HasLast = true;
  return force;
}

Vector3 SafetyChain::Shape(const SafetyInput& input) noexcept
{
  const double period = this->PeriodBefore(input.Observed);
  const Twist path = this->PathBefore(input.Observed);
  this->KeepBooks(input.Observed, path, period);
  const double factor = this->Ramp.Advance(period);
  Vector3 contact = factor * this->Guard.Apply(input.ContactForce);
  Vector3 torque = factor * this->Guard.Apply(input.ContactTorque);
  const Vector3 ambient = factor * this->Guard.Apply(input.AmbientForce);
  if (!input.IsTouching && this->AppliedContact.isZero(0.0) && this->AppliedTorque.isZero(0.0))
  {
    this->Energy.Close();
  }
  // By the unfiltered difference: a filtered velocity is too late to absorb energy.
  const ToolWrench damping =
      this->Energy.Damping({contact, torque}, {path.Shift / period, path.Turn / period}, period);
  contact += damping.Force;
  torque += damping.Torque;

  const Vector3 limited = this->Limit.Apply(contact + ambient);
  const Vector3 slewed = this->Slew.Apply(limited, period);
  // All forces between two allowed ones are allowed, up to rounding.
  const bool isLimited = this->Limit.IsLimiting();
  Vector3 force = this->Limit.Apply(slewed);
  // Exactly zero without contact, once the slew limit has settled.
  this->AppliedContact = force - ambient;
  const double wanted = (contact + ambient).norm();
  const double kept = isLimited ? limited.norm() / wanted : 1.0;
  this->AppliedTorque = this->TorqueLimit.Apply(
      this->TorqueSlew.Apply(this->TorqueLimit.Apply(kept * torque), period));

  const bool isDamping = !damping.Force.isZero(0.0) || !damping.Torque.isZero(0.0);
  this->LastReport = {SafetyFault::None,      true,  this->Ramp.IsRamping(), isDamping, isLimited,
                      this->Slew.IsSlewing(), false, this->Energy.Energy()};
  return force;
}
} // namespace palpate
