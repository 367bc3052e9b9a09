#pragma once

#include "TouchState.h"
#include "Vector3.h"

#include <cstdint>

namespace palpate
{
/// Waits until a hand that was led to a rest, without contacts, has arrived there and is still, so
/// that it can press. One that presses while it still moves would swing into what it touches, where
/// nothing is felt. For one thread.
class HandPress
{
public:
  /// mm of the hand above what it will press: the mechanism's friction may stop it that far from
  /// its goal.
  static constexpr double Hover = 0.6;

  /// Waits for a hand that was led to `restDevice` (mm, of the device), from this tick on.
  void Await(const Vector3& restDevice, std::uint64_t tick);
  void GiveUp() { this->Waits = false; }
  bool IsWaiting() const { return this->Waits; }
  const Vector3& Rest() const { return this->Goal; }

  /// Takes the next tick. True once: the hand is within the hover of its goal, or nothing moves it
  /// nearer, and the press may begin.
  bool Take(const TouchState& tick);

private:
  bool Waits = false;
  Vector3 Goal = Vector3::Zero();
  std::uint64_t First = 0; // tick
  Vector3 StillAt = Vector3::Zero();
  std::uint64_t StillSince = 0; // tick
};
} // namespace palpate
