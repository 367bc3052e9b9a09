#pragma once

#include "Vector3.h"

namespace palpate
{
/// Keeps the force of a hand at or below what it was when another scene took over, whatever that
/// scene changed: a resting hand is never pushed harder because a program changed something.
/// Pushing on raises the limit by the stiffness times the distance, and retreating lowers it, so a
/// contact feels like a spring that begins where the hand is. The limit ends once it has not been
/// needed for a while, as when the tool has left. All in the device's frame.
class HandoverLimit
{
public:
  /// No limit.
  HandoverLimit() noexcept = default;
  /// After a scene whose contacts exerted `force` (N) with the hand at `hand` (mm).
  HandoverLimit(double force, const Vector3& hand) noexcept
      : Most(force), Hand(hand), IsActive(true)
  {
  }

  bool IsOver() const noexcept { return !this->IsActive; }
  /// `force` (N), shortened if necessary, of contacts of `stiffness` (N/mm) with the hand at `hand`
  /// (mm), `passed` (s) after the last call.
  Vector3 Limited(const Vector3& force, double stiffness, const Vector3& hand,
                  double passed) noexcept;

private:
  double Most = 0.0;     // N
  double Unneeded = 0.0; // s, so far
  Vector3 Hand = Vector3::Zero();
  bool IsActive = false;
};
} // namespace palpate
