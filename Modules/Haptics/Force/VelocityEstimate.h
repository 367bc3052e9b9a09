#pragma once

#include "Vector3.h"

namespace palpate
{
/// The velocity of something that is measured at ticks: differences of positions through a low-pass
/// filter of first order, since one count of an encoder in one tick is already some 50 mm/s. Its
/// gain is 1 for steady motion and never more, which the bounds of stable damping rely on.
class VelocityEstimate
{
public:
  /// `timeConstant` (s) of the filter; 0 takes the bare differences.
  explicit VelocityEstimate(double timeConstant) noexcept : TimeConstant(timeConstant) {}

  /// The position (any length unit) at this tick, `period` (s) after the last one. Returns the
  /// velocity (the same unit, per s): 0 at the first tick. A position that is not finite begins
  /// anew, and so does a period that is not positive.
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
