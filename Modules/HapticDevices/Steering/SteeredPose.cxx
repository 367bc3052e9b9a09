#include "SteeredPose.h"

#include "ClampedLength.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr double LongestPeriod = 0.05; // s; after a pause the hand does not jump
constexpr double Relaxing = 20.0;      // mm/s

// Small deflections are fine, full ones fast: half of the deflection is about a fifth of the speed.
double Response(double deflection) noexcept
{
  return deflection * (0.2 + 0.8 * deflection * deflection);
}
} // namespace

void SteeredPose::Begin(const Vector3& placeDevice) noexcept
{
  this->Place = placeDevice;
  this->Ahead = 0.0;
  this->Turned.setIdentity();
}

// Without the dead zone, no longer than 1; zero for one that is not finite.
Vector3 SteeredPose::Deflection(const PlainVector3& given) const noexcept
{
  const Vector3 all(given);
  const double length = all.norm();
  if (!(length > this->Settings.DeadZone) || !std::isfinite(length))
  {
    return Vector3::Zero();
  }
  const double used =
      (std::min(length, 1.0) - this->Settings.DeadZone) / (1.0 - this->Settings.DeadZone);
  return used / length * all;
}

void SteeredPose::Advance(const SteeringInput& input, const Vector3& handDevice, double distance,
                          double period) noexcept
{
  const double passed = std::clamp(period, 0.0, LongestPeriod);
  const Vector3 push = this->Deflection(input.Push);
  const double pushed = push.norm();
  const double far = std::clamp(distance / this->Settings.FarDistance, 0.0, 1.0);
  const double slowness = this->Settings.NearSpeed + (1.0 - this->Settings.NearSpeed) * far;
  if (pushed > 0.0)
  {
    this->Place += slowness * this->Settings.FullSpeed * passed * Response(pushed) / pushed * push;
  }
  // Shorter by little at a time: a hand whose stick is let go would be thrown off the surface.
  this->Ahead = std::max(pushed * this->Settings.Lead, this->Ahead - Relaxing * passed);
  this->Place = handDevice + ClampedLength(this->Place - handDevice, this->Ahead);
  this->Place = this->Place.cwiseMax(-this->Settings.Reach).cwiseMin(this->Settings.Reach);

  const Vector3 turn = this->Deflection(input.Turn);
  const double turned = turn.norm();
  if (turned > 0.0)
  {
    const double angle = this->Settings.FullTurn * passed * Response(turned);
    this->Turned = (Eigen::AngleAxisd(angle, turn / turned) * this->Turned).normalized();
  }
}
} // namespace palpate
