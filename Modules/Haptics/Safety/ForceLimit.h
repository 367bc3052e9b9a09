#pragma once

#include "Vector3.h"

namespace palpate
{
/// Limits forces to the device's maximum, keeping their direction: clipped by axis, or by a
/// saturating amplifier, a strong force would change direction.
class ForceLimit
{
public:
  /// `maximum` in N; if not positive or NaN, there is no force at all.
  explicit ForceLimit(double maximum) noexcept : Maximum(maximum) {}

  /// Never longer than the maximum, and finite for any input.
  Vector3 Apply(const Vector3& force) noexcept;
  /// Whether the last force was limited.
  bool IsLimiting() const noexcept { return this->Limiting; }

private:
  double Maximum; // N
  bool Limiting = false;
};
} // namespace palpate
