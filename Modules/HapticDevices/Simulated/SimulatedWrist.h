#pragma once

#include "HeldMass.h"

namespace palpate
{
/// A relaxed hand that holds a tool firmly, and a mechanism, which are plausible, not measured on a
/// device: the hand's inertia about the wrist, and the wrist's stiffness and damping, in round
/// numbers of the order that is published: 0.003 kg m^2, 1 N m/rad and 0.03 N m s/rad (Charles and
/// Hogan, "Dynamics of wrist rotations", J. Biomechanics 44, 2011; Formica et al., "The passive
/// stiffness of the wrist and forearm", J. Neurophysiology 108, 2012; Peaden and Charles, "Dynamics
/// of wrist and forearm rotations", J. Biomechanics 47, 2014). The same about all axes.
inline HandProperties WristProperties() noexcept
{
  HandProperties wrist;
  wrist.Mass = 3000.0;          // kg mm^2
  wrist.HandStiffness = 1000.0; // N mm/rad
  wrist.HandDamping = 30.0;     // N mm s/rad
  wrist.Damping = 1.0;          // N mm s/rad
  wrist.Friction = 2.0;         // N mm
  return wrist;
}

/// How a hand's mass is turned.
class SimulatedWrist
{
public:
  SimulatedWrist(const HandProperties& properties, const Eigen::Quaterniond& start) noexcept
      : Held(properties), Now(start)
  {
  }

  /// One step of `step` (s), with a constant `torque` (N mm) of the motors; `targetVelocity` in
  /// rad/s.
  void Advance(const Eigen::Quaterniond& target, const Vector3& targetVelocity,
               const Vector3& torque, double step) noexcept;

  const Eigen::Quaterniond& Orientation() const noexcept { return this->Now; }
  const Vector3& Velocity() const noexcept { return this->Held.Velocity(); } ///< rad/s
  const HandEnergy& Energy() const noexcept { return this->Held.Energy(); }  ///< N mm

private:
  HeldMass Held;
  Eigen::Quaterniond Now;
};
} // namespace palpate
