#pragma once

#include "Vector3.h"

namespace palpate
{
/// Lets through forces that are numbers a hand could be meant to feel, and nothing else.
class NonFiniteGuard
{
public:
  /// No force of a scene comes near this (N); what is above it is a failed computation.
  static constexpr double LargestSane = 1e6;

  /// The force, or zero where a component is NaN, infinite or above LargestSane.
  Vector3 Apply(const Vector3& force) noexcept;
  /// Whether one was stopped since Reset.
  bool HasTripped() const noexcept { return this->Tripped; }
  void Reset() noexcept { this->Tripped = false; }

private:
  bool Tripped = false;
};
} // namespace palpate
