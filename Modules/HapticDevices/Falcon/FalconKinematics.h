#pragma once

#include "FalconGeometry.h"

namespace palpate
{
/// Forward and inverse kinematics of the grip, and the torques at the thighs for a force at the
/// grip. Positions in mm from the base's centre: x to the user's right, y up, z out of the device
/// towards the user. Angles in rad, torques in N mm, one per leg.
///
/// Every function returns whether there is a solution and otherwise leaves its result unchanged:
/// there is none where a leg does not reach, or only with its thigh beyond its limits; nor where
/// the mechanism is close to a singular pose, or beyond one, which only another assembly mode
/// reaches. Const and allocation-free, for the servo thread.
class FalconKinematics
{
public:
  explicit FalconKinematics(const FalconGeometry& geometry);

  const FalconGeometry& Geometry() const noexcept { return this->Lengths; }

  /// Inverse kinematics in closed form.
  bool AnglesAt(const Vector3& position, Vector3& angles) const noexcept;

  /// Forward kinematics by Newton's method on AnglesAt, from `start` (the last position) and, if
  /// that fails, from the centre. Steps are limited, and shortened until they converge. The result
  /// has the requested angles within 1e-9 rad.
  bool PositionAt(const Vector3& angles, const Vector3& start, Vector3& position) const noexcept;

  /// d angle / d position, rad/mm, one row per leg.
  bool Jacobian(const Vector3& position, Matrix3& jacobian) const noexcept;

  /// Torques at the thighs, positive where an angle grows, that push the grip with `force` (N):
  /// virtual work, tau = (dp / d angle)^T F.
  bool TorquesFor(const Vector3& force, const Vector3& position, Vector3& torques) const noexcept;

  /// The largest force that torques of up to `torque` (N mm) per leg can produce in the weakest
  /// direction; 0 if there is no solution.
  double LeastForce(double torque, const Vector3& position) const noexcept;

  Vector3 AnglesOf(const Vector3& counts) const noexcept
  {
    return this->Lengths.HomeAngles + this->Lengths.AnglePerCount * counts;
  }
  /// The centre of the workspace.
  Vector3 Center() const noexcept { return {0.0, 0.0, this->Lengths.CenterHeight}; }

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
  double Determinant = 0.0; // of the Jacobian in the centre
};
} // namespace palpate
