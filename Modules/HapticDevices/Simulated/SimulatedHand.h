#pragma once

#include "Vector3.h"

namespace palpate
{
/// A hand on a mechanism, as one mass in space: a spring and a damper of the hand pull it to its
/// target, the motors push it, the mechanism's viscous damping and Coulomb friction resist.
struct HandProperties
{
  double Mass = 0.25;         ///< kg, of hand and mechanism together
  double HandStiffness = 0.5; ///< N/mm
  double HandDamping = 0.005; ///< N s/mm
  double Damping = 0.002;     ///< N s/mm, of the mechanism
  double Friction = 0.2;      ///< N, of the mechanism
};

/// Energy balance since the start, N mm. Motion + both losses = both works, up to rounding.
struct HandEnergy
{
  double HandWork = 0.0;     ///< by the hand's spring and damper
  double MotorWork = 0.0;    ///< by the motors
  double DampingLoss = 0.0;  ///< in the mechanism
  double FrictionLoss = 0.0; ///< in the mechanism
  double Motion = 0.0;       ///< kinetic

  /// Energy that motors and mechanism together have absorbed from the hand: never negative for a
  /// passive virtual wall.
  double TakenIn() const noexcept
  {
    return this->DampingLoss + this->FrictionLoss - this->MotorWork;
  }
};

/// Integrates that mass. In every step the mean of the velocities before and after it moves the
/// mass, so that each force's work is exactly force times path and the energies balance to
/// rounding.
class SimulatedHand
{
public:
  SimulatedHand(const HandProperties& properties, const Vector3& start) noexcept
      : Properties(properties), Place(start)
  {
  }

  /// One step of `step` (s), with a constant `force` (N) of the motors.
  void Advance(const Vector3& target, const Vector3& targetVelocity, const Vector3& force,
               double step) noexcept;

  const Vector3& Position() const noexcept { return this->Place; }        ///< mm
  const Vector3& Velocity() const noexcept { return this->Speed; }        ///< mm/s
  const HandEnergy& Energy() const noexcept { return this->Bookkeeping; } ///< N mm

private:
  HandProperties Properties;
  Vector3 Place;
  Vector3 Speed = Vector3::Zero();
  HandEnergy Bookkeeping;
};
} // namespace palpate
