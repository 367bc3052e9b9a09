#pragma once

#include "Vector3.h"

namespace palpate
{
/// Limits how fast the force changes, so that a step in a computation is no blow.
class SlewLimit
{
public:
  /// `rate` in N/s; not positive or not a number lets nothing change.
  explicit SlewLimit(double rate) noexcept : Rate(rate) {}

  /// On the straight way from the last force to this one, as far as `period` (s) allows. Finite for
  /// any input; what is not finite is taken as zero.
  Vector3 Apply(const Vector3& force, double period) noexcept;
  /// Whether the last change was cut.
  bool IsSlewing() const noexcept { return this->Slewing; }
  /// The next change begins from here.
  void Reset(const Vector3& force = Vector3::Zero()) noexcept { this->Last = force; }

private:
  double Rate; // N/s
  Vector3 Last = Vector3::Zero();
  bool Slewing = false;
};
} // namespace palpate
