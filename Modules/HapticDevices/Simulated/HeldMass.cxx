#include "HeldMass.h"

namespace palpate
{
namespace
{
// N / kg in mm/s^2, and N mm / (kg mm^2) in rad/s^2.
constexpr double MillimetersPerMeter = 1000.0;
} // namespace

Vector3 HeldMass::Advance(const Vector3& away, const Vector3& targetVelocity, const Vector3& push,
                          double step) noexcept
{
  const HandProperties& p = this->Properties;
  const Vector3 before = this->Speed;
  const Vector3 hand = p.HandStiffness * away + p.HandDamping * (targetVelocity - before);
  const double gain = MillimetersPerMeter * step / p.Mass; // mm/s per N
  // The mechanism's damping acts on the mean velocity, so it dissipates energy for any step.
  const double half = 0.5 * gain * p.Damping;
  const Vector3 pushed = ((1.0 - half) * before + gain * (hand + push)) / (1.0 + half);
  // Friction decelerates to rest, but not beyond.
  const double speed = pushed.norm();
  const double slowed = gain * p.Friction / (1.0 + half);
  const Vector3 after = speed > slowed ? Vector3(pushed * (1.0 - slowed / speed)) : Vector3::Zero();

  const Vector3 mean = 0.5 * (before + after);
  const Vector3 displacement = step * mean;
  HandEnergy& e = this->Bookkeeping;
  const double motion = 0.5 * p.Mass / MillimetersPerMeter * after.squaredNorm();
  const double works = (hand + push).dot(displacement);
  const double damped = p.Damping * mean.dot(displacement);
  e.HandWork += hand.dot(displacement);
  e.MotorWork += push.dot(displacement);
  e.DampingLoss += damped;
  e.FrictionLoss += works - damped - (motion - e.Motion);
  e.Motion = motion;
  this->Speed = after;
  return displacement;
}
} // namespace palpate
