#pragma once

#include "PoseConstraints.h"
#include "ToolWrench.h"

namespace palpate
{
/// Observes the energy that a contact absorbs from the hand, and adds damping when it has returned
/// more than it absorbed: passivity observer and controller of Hannaford and Ryu, "Time-domain
/// passivity control of haptic interfaces", IEEE Trans. Robotics and Automation 18 (2002).
///
/// A force is held from one tick to the next, so the energy of a tick is exactly the held force
/// times the displacement, without any velocity. The balance is reset when the contact ends: energy
/// absorbed by one contact is no credit for the next.
///
/// A sampled spring generates a little energy in every motion, K T / 2 times velocity squared, and
/// so do encoder counts; a mechanism's own damping and friction absorb it. Their guaranteed part is
/// credited, or every stable wall would be damped. Torques and turns count as forces and motions.
class EnergyObserver
{
public:
  /// `largestDamping` (N s/mm): the device's limit; 0 only observes. `turnLength` (mm): its
  /// DeviceCapabilities::TurnLength, whose square times the same damps turns.
  explicit EnergyObserver(double largestDamping, double turnLength = 0.0) noexcept
      : LargestDamping(largestDamping), TurnLength(turnLength)
  {
  }

  /// The hand moved by `path` while `wrench` was applied.
  void Account(const ToolWrench& wrench, const Twist& path) noexcept;
  /// Energy (N mm) absorbed by the mechanism itself; ignored if not positive.
  void Credit(double energy) noexcept;
  /// What to add to the contact's wrench, against the hand's velocity (mm/s, rad/s), that absorbs
  /// the excess energy in one `period` (s). It never turns the contact's push into a pull, nor a
  /// torque into its opposite.
  ToolWrench Damping(const ToolWrench& contact, const Twist& velocity, double period) noexcept;
  /// The contact has ended.
  void Close() noexcept { this->Balance = 0.0; }

  /// N mm absorbed since the contact began.
  double Energy() const noexcept { return this->Balance; }

private:
  double LargestDamping;
  double TurnLength; // mm
  double Balance = 0.0;
};
} // namespace palpate
