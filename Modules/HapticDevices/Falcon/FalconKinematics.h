#pragma once

#include "FalconGeometry.h"

namespace palpate
{
/// Where the grip is for given angles of the three thighs and back, and which torques at the thighs
/// make a force at the grip. Positions in mm from the base's middle: x to the user's right, y up, z
/// out of the device towards the user. Angles in rad, torques in N mm, one a leg.
///
/// Every function says whether there is an answer and leaves its result alone where there is none:
/// where a leg does not reach, or only with its thigh beyond its limits; and where the mechanism is
/// close to a pose in which its legs would no longer hold the grip, or behind one, where only
/// another assembly would get.
/// Const and without allocation, for the servo thread.
class FalconKinematics
{
public:
  explicit FalconKinematics(const FalconGeometry& geometry);

  const FalconGeometry& Geometry() const noexcept { return this->Lengths; }

  /// In closed form.
  bool AnglesAt(const Vector3& position, Vector3& angles) const noexcept;

  /// By Newton's method on AnglesAt, from `start` (where the grip was last) and, where that leads
  /// nowhere, from the middle. Steps are limited, and shortened until they come nearer. What it
  /// gives has the wanted angles within 1e-9 rad.
  bool PositionAt(const Vector3& angles, const Vector3& start, Vector3& position) const noexcept;

  /// d angle / d position, rad/mm, a row a leg.
  bool Jacobian(const Vector3& position, Matrix3& jacobian) const noexcept;

  /// Torques at the thighs, positive where an angle grows, that push the grip with `force` (N):
  /// virtual work, tau = (dp / d angle)^T F.
  bool TorquesFor(const Vector3& force, const Vector3& position, Vector3& torques) const noexcept;

  /// The force in the direction in which it is least that torques of up to `torque` (N mm) a leg
  /// can make; 0 where there is no answer.
  double LeastForce(double torque, const Vector3& position) const noexcept;

  Vector3 AnglesOf(const Vector3& counts) const noexcept
  {
    return this->Lengths.HomeAngles + this->Lengths.AnglePerCount * counts;
  }
  /// The middle of the space in which a grip moves.
  Vector3 Middle() const noexcept { return {0.0, 0.0, this->Lengths.MiddleHeight}; }

private:
  // The thigh's angle, and its derivatives by the position in the leg's own plane, across it, and
  // along the height.
  struct Leg
  {
    double Thigh = 0.0;
    double ByRadial = 0.0;
    double ByTangential = 0.0;
    double ByHeight = 0.0;
  };
  bool Solve(int leg, const Vector3& position, Leg& solution) const noexcept;
  bool Evaluate(const Vector3& position, Vector3& angles, Matrix3& jacobian) const noexcept;
  bool Descend(const Vector3& angles, Vector3& position) const noexcept;
  bool IsInside(const Vector3& position, const Vector3& angles,
                const Matrix3& jacobian) const noexcept;

  FalconGeometry Lengths;
  Vector3 Cosines; // of the legs' directions
  Vector3 Sines;
  double Determinant = 0.0; // of the Jacobian in the middle
};
} // namespace palpate
