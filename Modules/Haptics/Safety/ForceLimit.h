#pragma once

#include "Vector3.h"

namespace palpate
{
/// Cuts forces to what the device can give, keeping their direction: cut axis by axis, or by a
/// saturating amplifier, a strong force would point elsewhere.
class ForceLimit
{
public:
  /// `maximum` in N; not positive or not a number means no force at all.
  explicit ForceLimit(double maximum) noexcept : Maximum(maximum) {}

  /// Never longer than the maximum, and finite for any input.
  Vector3 Apply(const Vector3& force) noexcept;
  /// Whether the last force was cut.
  bool IsLimiting() const noexcept { return this->Limiting; }

private:
  double Maximum; // N
  bool Limiting = false;
};
} // namespace palpate
