#pragma once

#include "SteeringSource.h"
#include "Vector3.h"

namespace palpate
{
struct SteeringSettings
{
  double FullSpeed = 80.0;   ///< mm/s at full deflection, far from every surface
  double FullTurn = 1.5;     ///< rad/s at full deflection
  double DeadZone = 0.08;    ///< deflections below are none: sticks do not return to their middle
  double Lead = 8.0;         ///< mm that the target is ahead of a hand that is held up, at full one
  double FarDistance = 20.0; ///< mm from a surface, from where the speed is full
  double NearSpeed = 0.25;   ///< part of the speed at a surface
  double Reach = 40.0;       ///< mm, in each direction of each axis
};

/// Where a computed hand is steered to: rate control, whose target is never farther ahead of the
/// hand than the deflection allows. So a hand that a surface holds up pushes as hard as the stick
/// is deflected, and one whose stick is released rests where it is. Does not allocate.
class SteeredPose
{
public:
  explicit SteeredPose(const SteeringSettings& settings = {}) noexcept : Settings(settings) {}

  /// Begins at a place (mm), without a turn.
  void Begin(const Vector3& placeDevice) noexcept;
  /// One tick of `period` (s), with the hand (mm) where it is now and the distance (mm) to the
  /// nearest surface; infinite if there is none.
  void Advance(const SteeringInput& input, const Vector3& handDevice, double distance,
               double period) noexcept;

  const Vector3& Target() const noexcept { return this->Place; } ///< mm
  const Eigen::Quaterniond& Orientation() const noexcept { return this->Turned; }

private:
  Vector3 Deflection(const PlainVector3& given) const noexcept;

  SteeringSettings Settings;
  Vector3 Place = Vector3::Zero();
  double Ahead = 0.0; // mm, the most by which it may be ahead of the hand
  Eigen::Quaterniond Turned = Eigen::Quaterniond::Identity();
};
} // namespace palpate
