#pragma once

#include "Vector3.h"

namespace palpate
{
/// The rotation vector (rad) that leads from one orientation to another, on the shorter way.
inline Vector3 TurnBetween(const Eigen::Quaterniond& from, const Eigen::Quaterniond& to) noexcept
{
  const Eigen::AngleAxisd turn(to * from.conjugate());
  const double angle = turn.angle() > EIGEN_PI ? turn.angle() - 2.0 * EIGEN_PI : turn.angle();
  return angle * turn.axis();
}

/// The orientation after a turn by a rotation vector (rad).
inline Eigen::Quaterniond TurnedBy(const Vector3& turn, const Eigen::Quaterniond& from) noexcept
{
  const double angle = turn.norm();
  return angle > 0.0 ? (Eigen::AngleAxisd(angle, turn.normalized()) * from).normalized() : from;
}
} // namespace palpate
