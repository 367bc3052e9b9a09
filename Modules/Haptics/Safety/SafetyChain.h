#pragma once

#include "EnergyObserver.h"
#include "ForceLimit.h"
#include "NonFiniteGuard.h"
#include "RampIn.h"
#include "SafetyReport.h"
#include "SlewLimit.h"
#include "VelocityEstimate.h"
#include "Watchdog.h"

namespace palpate
{
struct SafetySettings
{
  double MaximumForce = 0.0;   ///< N; without one there is no force
  double MaximumSlew = 2000.0; ///< N/s
  double RampDuration = 0.3;   ///< s
  double LargestDamping = 0.0; ///< N s/mm, that the energy observer may add
  double DeviceDamping = 0.0;  ///< N s/mm, that the mechanism has by itself; 0 if not known
  double DeviceFriction = 0.0; ///< N, likewise
  WatchdogLimits Limits;
};

/// What a tick wants to do; everything in the device's frame.
struct SafetyInput
{
  TickObservation Observed;
  SafetyFault SceneFault = SafetyFault::None; ///< what the scene found wrong with itself
  bool IsTouching = false;
  Vector3 ContactForce = Vector3::Zero(); ///< N
  Vector3 AmbientForce = Vector3::Zero(); ///< N, what acts without touch too
};

/// Stands between everything that computes forces and the device; it cannot be switched off. In
/// this order: watchdog, guard against what is no number, ramp, energy observer, limit, slew limit.
///
/// For any input its output is finite and no longer than MaximumForce. A fault gives 0 N at once
/// and for good, until Rearm. Not before the device is Ready does it let anything through.
class SafetyChain
{
public:
  explicit SafetyChain(const SafetySettings& settings) noexcept;

  /// Once a tick: the force (N, device's frame) to apply.
  Vector3 Apply(const SafetyInput& input) noexcept;
  /// A fault that only applying showed.
  void Fail(SafetyFault fault) noexcept;
  /// Forgets a fault and begins anew, fading in.
  void Rearm() noexcept;
  /// After a pause between two ticks: forgets motion and fades in. A fault stays.
  void Resume() noexcept;
  /// Fades in anew, since the scene is another one.
  void FadeIn() noexcept;

  const SafetyReport& Report() const noexcept { return this->LastReport; }

private:
  SafetyFault FaultOf(const SafetyInput& input) noexcept;
  Vector3 Shape(const SafetyInput& input) noexcept;
  double PeriodBefore(const TickObservation& now) const noexcept;
  Vector3 WayBefore(const TickObservation& now) const noexcept;
  void KeepBooks(const TickObservation& now, const Vector3& way, double period) noexcept;
  Vector3 Zero() noexcept;

  Watchdog Dog;
  NonFiniteGuard Guard;
  RampIn Ramp;
  EnergyObserver Energy;
  ForceLimit Limit;
  SlewLimit Slew;
  SafetyReport LastReport;
  VelocityEstimate Motion; // mm/s
  double DeviceDamping;    // N s/mm
  double DeviceFriction;   // N
  TickObservation Last;
  bool HasLast = false;
  Vector3 AppliedContact = Vector3::Zero(); // N, of the last tick, held since
};
} // namespace palpate
