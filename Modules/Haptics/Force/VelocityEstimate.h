#pragma once

#include "Vector3.h"

namespace palpate
{
/// Velocity of a position sampled at ticks: differences through a first-order low-pass filter,
/// since one encoder count per tick is already some 50 mm/s. Its gain is 1 for steady motion and
/// never more, as the bounds of stable damping require.
class VelocityEstimate
{
public:
  /// `timeConstant` (s) of the filter; 0 for unfiltered differences.
  explicit VelocityEstimate(double timeConstant) noexcept : TimeConstant(timeConstant) {}

  /// The position (any length unit) at this tick, `period` (s) after the last one. Returns the
  /// velocity (same unit, per s): 0 at the first tick. Restarts at a position that is not finite or
  /// a period that is not positive.
  const Vector3& Update(const Vector3& position, double period) noexcept;
  const Vector3& Velocity() const noexcept { return this->Filtered; }
  void Reset() noexcept;

private:
  double TimeConstant;
  Vector3 Last = Vector3::Zero();
  Vector3 Filtered = Vector3::Zero();
  bool HasLast = false;
};
} // namespace palpate
