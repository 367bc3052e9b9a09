#pragma once

#include "Vector3.h"

namespace palpate
{
/// Limits the rate of change of the force, so that a step in a computation is no blow.
class SlewLimit
{
public:
  /// `rate` in N/s; if not positive or NaN, the force cannot change.
  explicit SlewLimit(double rate) noexcept : Rate(rate) {}

  /// The point on the line from the last force to this one that `period` (s) allows. Finite for any
  /// input; a force that is not finite counts as zero.
  Vector3 Apply(const Vector3& force, double period) noexcept;
  /// Whether the last change was limited.
  bool IsSlewing() const noexcept { return this->Slewing; }
  /// Sets the start of the next change.
  void Reset(const Vector3& force = Vector3::Zero()) noexcept { this->Last = force; }

private:
  double Rate; // N/s
  Vector3 Last = Vector3::Zero();
  bool Slewing = false;
};
} // namespace palpate
