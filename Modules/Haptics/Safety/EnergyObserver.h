#pragma once

#include "Vector3.h"

namespace palpate
{
/// Watches the energy that a contact takes in from the hand, and adds damping when it has given out
/// more than it took in: passivity observer and controller of Hannaford and Ryu, "Time-domain
/// passivity control of haptic interfaces", IEEE Trans. Robotics and Automation 18 (2002).
///
/// A force is held from one tick to the next, so the energy of a tick is exactly the held force
/// times the way moved, without any velocity. The books are closed when the contact ends: what one
/// contact took in is no credit for the next.
///
/// A sampled spring gives out a little in every motion, K T / 2 times velocity squared, and encoder
/// counts do too; a mechanism's own damping and friction take it up. What they certainly did is
/// credited, or every stable wall would be damped.
class EnergyObserver
{
public:
  /// `largestDamping` (N s/mm): as much as the device bears; 0 only observes.
  explicit EnergyObserver(double largestDamping) noexcept : LargestDamping(largestDamping) {}

  /// The hand moved by `way` (mm) while it was pushed with `force` (N).
  void Account(const Vector3& force, const Vector3& way) noexcept;
  /// The mechanism itself took up this much (N mm) meanwhile; what is not positive is ignored.
  void Credit(double energy) noexcept;
  /// The force (N) to add to the contact's, against the hand's velocity (mm/s), that takes up in
  /// one `period` (s) what was given out too much. It never turns the contact's push into a pull.
  Vector3 Damping(const Vector3& contactForce, const Vector3& velocity, double period) noexcept;
  /// The contact is over.
  void Close() noexcept { this->Balance = 0.0; }

  /// N mm taken in since the contact began.
  double Energy() const noexcept { return this->Balance; }

private:
  double LargestDamping;
  double Balance = 0.0;
};
} // namespace palpate
