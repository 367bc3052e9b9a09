#pragma once

#include "Vector3.h"

namespace palpate
{
/// A hand on a mechanism, as one mass in space: a spring and a damper of the hand pull it to its
/// target, the motors push it, the mechanism's viscous damping and Coulomb friction resist.
///
/// The same describes turns, with a moment of inertia and the units in brackets.
struct HandProperties
{
  double Mass = 0.25;         ///< kg [kg mm^2], of hand and mechanism together
  double HandStiffness = 0.5; ///< N/mm [N mm/rad]
  double HandDamping = 0.005; ///< N s/mm [N mm s/rad]
  double Damping = 0.002;     ///< N s/mm [N mm s/rad], of the mechanism
  double Friction = 0.2;      ///< N [N mm], of the mechanism
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

/// The motion of that mass. In every step the mean of the velocities before and after it moves the
/// mass, so that each force's work is exactly force times path and the energies balance to
/// rounding. Units as in HandProperties.
class HeldMass
{
public:
  explicit HeldMass(const HandProperties& properties) noexcept : Properties(properties) {}

  /// One step of `step` (s), with the hand's target `away` (mm [rad]) and a constant `push` (N
  /// [N mm]) of the motors. Returns by how much the mass moves (mm [rad]).
  Vector3 Advance(const Vector3& away, const Vector3& targetVelocity, const Vector3& push,
                  double step) noexcept;

  const Vector3& Velocity() const noexcept { return this->Speed; } ///< mm/s [rad/s]
  const HandEnergy& Energy() const noexcept { return this->Bookkeeping; }

private:
  HandProperties Properties;
  Vector3 Speed = Vector3::Zero();
  HandEnergy Bookkeeping;
};
} // namespace palpate
