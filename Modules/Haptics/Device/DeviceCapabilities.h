#pragma once

#include "PlainVector3.h"
#include "Vector3.h"

#include <algorithm>
#include <string>

namespace palpate
{
/// Properties of a device, in its own frame; 0 for unknown numbers.
struct DeviceCapabilities
{
  std::string Name;              ///< for display
  int DegreesOfFreedom = 3;      ///< of the measured pose: 3 or 6
  int Buttons = 0;               ///< number of them; 0: none, or not known
  Eigen::AlignedBox3d Workspace; ///< mm
  double MaximumForce = 0.0;     ///< N, in any direction
  double MaximumTorque = 0.0;    ///< N mm, about any axis; 0 if it shows none
  double MaximumStiffness = 0.0; ///< N/mm, stable according to its manufacturer or experience
  double MaximumDamping = 0.0;   ///< N s/mm, of commanded forces, likewise
  double Damping = 0.0;          ///< N s/mm, of the mechanism itself
  double Friction = 0.0;         ///< N, Coulomb friction of the mechanism itself
  double Resolution = 0.0;       ///< mm per encoder count
  double Delay = 0.0;            ///< s, from the measurement of a position to its force at the hand
  double Rate = 0.0;             ///< Hz, of new samples
  /// Longest normal interval (s) between new samples, as on a shared bus; 0: one period.
  double LongestGap = 0.0;
  /// Whether forces may reach a person. False only for a computed hand: faults of timing then end
  /// by themselves (FaultRecovery).
  bool HasMotors = true;

  /// N, device's frame: force that carries the weight of its handle. The servo adds it to the
  /// scene's forces, so that it passes the safety chain too.
  PlainVector3 GravityCompensation;

  /// mm: a turn by one rad counts as much as a motion by it, and a torque as much as a force by it.
  /// 0 if it shows no torque. Equal motors behind other gears have this square times the damping,
  /// so a coupling of the stiffness k and at most k times this square for turns is as stable in
  /// turns as in motions.
  double TurnLength() const noexcept
  {
    return this->MaximumForce > 0.0 ? this->MaximumTorque / this->MaximumForce : 0.0;
  }

  /// Guaranteed rate of new samples, Hz.
  double LeastRate() const noexcept
  {
    return this->LongestGap > 0.0 ? std::min(this->Rate, 1.0 / this->LongestGap) : this->Rate;
  }
};
} // namespace palpate
