#pragma once

#include "Vector3.h"

namespace palpate
{
/// Blocks forces that are not finite or not plausible.
class NonFiniteGuard
{
public:
  /// N; no scene's forces come near this, so a larger one is a failed computation.
  static constexpr double LargestSane = 1e6;

  /// The force, or zero where a component is NaN, infinite or above LargestSane.
  Vector3 Apply(const Vector3& force) noexcept;
  /// Whether a force was blocked since Reset.
  bool HasTripped() const noexcept { return this->Tripped; }
  void Reset() noexcept { this->Tripped = false; }

private:
  bool Tripped = false;
};
} // namespace palpate
