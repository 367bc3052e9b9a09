#pragma once

#include "Vector3.h"

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
/// credited, or every stable wall would be damped.
class EnergyObserver
{
public:
  /// `largestDamping` (N s/mm): the device's limit; 0 only observes.
  explicit EnergyObserver(double largestDamping) noexcept : LargestDamping(largestDamping) {}

  /// The hand moved by `path` (mm) while `force` (N) was applied.
  void Account(const Vector3& force, const Vector3& path) noexcept;
  /// Energy (N mm) absorbed by the mechanism itself; ignored if not positive.
  void Credit(double energy) noexcept;
  /// The force (N) to add to the contact's, against the hand's velocity (mm/s), that absorbs the
  /// excess energy in one `period` (s). It never turns the contact's push into a pull.
  Vector3 Damping(const Vector3& contactForce, const Vector3& velocity, double period) noexcept;
  /// The contact has ended.
  void Close() noexcept { this->Balance = 0.0; }

  /// N mm absorbed since the contact began.
  double Energy() const noexcept { return this->Balance; }

private:
  double LargestDamping;
  double Balance = 0.0;
};
} // namespace palpate
