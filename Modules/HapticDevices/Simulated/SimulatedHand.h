#pragma once

#include "HeldMass.h"

namespace palpate
{
/// Where a hand's mass is.
class SimulatedHand
{
public:
  SimulatedHand(const HandProperties& properties, const Vector3& start) noexcept
      : Held(properties), Place(start)
  {
  }

  /// One step of `step` (s), with a constant `force` (N) of the motors.
  void Advance(const Vector3& target, const Vector3& targetVelocity, const Vector3& force,
               double step) noexcept
  {
    this->Place += this->Held.Advance(target - this->Place, targetVelocity, force, step);
  }

  const Vector3& Position() const noexcept { return this->Place; }           ///< mm
  const Vector3& Velocity() const noexcept { return this->Held.Velocity(); } ///< mm/s
  const HandEnergy& Energy() const noexcept { return this->Held.Energy(); }  ///< N mm

private:
  HeldMass Held;
  Vector3 Place;
};
} // namespace palpate
