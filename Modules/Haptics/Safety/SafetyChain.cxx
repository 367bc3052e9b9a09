#include "SafetyChain.h"

#include "TurnBetween.h"

namespace palpate
{
namespace
{
// s. The filter's gain is at most 1, so no more is credited than was absorbed.
constexpr double MotionTimeConstant = 0.003;

// N mm/s: all of the torque in the time of all of the force.
double TorqueRate(const SafetySettings& settings) noexcept
{
  return settings.MaximumForce > 0.0
             ? settings.MaximumSlew / settings.MaximumForce * settings.MaximumTorque
             : 0.0;
}
} // namespace

SafetyChain::SafetyChain(const SafetySettings& settings) noexcept
    : Dog(settings.Limits), Recovery(settings.HasMotors), Ramp(settings.RampDuration),
      Energy(settings.LargestDamping), Limit(settings.MaximumForce), Slew(settings.MaximumSlew),
      TorqueLimit(settings.MaximumTorque), TorqueSlew(TorqueRate(settings)),
      Motion(MotionTimeConstant), DeviceDamping(settings.DeviceDamping),
      DeviceFriction(settings.DeviceFriction)
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

Vector3 SafetyChain::PathBefore(const TickObservation& now) const noexcept
{
  return this->HasLast ? Vector3(Vector3(now.Sample.Position) - Vector3(this->Last.Sample.Position))
                       : Vector3::Zero();
}

void SafetyChain::KeepBooks(const TickObservation& now, const Vector3& path, double period) noexcept
{
  const double speed = this->Motion.Update(now.Sample.Position, period).norm();
  this->Energy.Account(this->AppliedContact, path);
  if (this->HasLast && !this->AppliedTorque.isZero(0.0))
  {
    const Eigen::Map<const Eigen::Quaterniond> before(this->Last.Sample.Orientation.data());
    const Eigen::Map<const Eigen::Quaterniond> after(now.Sample.Orientation.data());
    this->Energy.Account(this->AppliedTorque, TurnBetween(before, after));
  }
  this->Energy.Credit((this->DeviceDamping * speed + this->DeviceFriction) * speed * period);
}

Vector3 SafetyChain::Zero() noexcept
{
  this->Motion.Reset();
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

Vector3 SafetyChain::ShapedTorque(const Vector3& torque, double factor, double period) noexcept
{
  const Vector3 limited = this->TorqueLimit.Apply(factor * this->Guard.Apply(torque));
  return this->TorqueLimit.Apply(this->TorqueSlew.Apply(limited, period));
}

Vector3 SafetyChain::Shape(const SafetyInput& input) noexcept
{
  const double period = this->PeriodBefore(input.Observed);
  const Vector3 path = this->PathBefore(input.Observed);
  this->KeepBooks(input.Observed, path, period);
  const double factor = this->Ramp.Advance(period);
  Vector3 contact = factor * this->Guard.Apply(input.ContactForce);
  const Vector3 ambient = factor * this->Guard.Apply(input.AmbientForce);
  if (!input.IsTouching && this->AppliedContact.isZero(0.0))
  {
    this->Energy.Close();
  }
  // By the unfiltered difference: a filtered velocity is too late to absorb energy.
  const Vector3 damping = this->Energy.Damping(contact, path / period, period);
  contact += damping;

  const Vector3 limited = this->Limit.Apply(contact + ambient);
  const Vector3 slewed = this->Slew.Apply(limited, period);
  // All forces between two allowed ones are allowed, up to rounding.
  const bool isLimited = this->Limit.IsLimiting();
  Vector3 force = this->Limit.Apply(slewed);
  // Exactly zero without contact, once the slew limit has settled.
  this->AppliedContact = force - ambient;
  const double wanted = (contact + ambient).norm();
  const double kept = isLimited ? limited.norm() / wanted : 1.0;
  this->AppliedTorque = this->ShapedTorque(input.ContactTorque, kept * factor, period);

  this->LastReport = {
      SafetyFault::None,      true,  this->Ramp.IsRamping(), !damping.isZero(0.0), isLimited,
      this->Slew.IsSlewing(), false, this->Energy.Energy()};
  return force;
}
} // namespace palpate
