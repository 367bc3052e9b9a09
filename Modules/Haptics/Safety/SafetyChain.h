#pragma once

#include "EnergyObserver.h"
#include "FaultRecovery.h"
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
  double MaximumForce = 0.0;   ///< N; 0: no force
  double MaximumSlew = 2000.0; ///< N/s
  double MaximumTorque = 0.0;  ///< N mm; 0: no torque
  /// mm, DeviceCapabilities::TurnLength: a torque changes as fast as a force times this.
  double TurnLength = 0.0;
  double RampDuration = 0.3;   ///< s
  double LargestDamping = 0.0; ///< N s/mm, limit for the energy observer
  double DeviceDamping = 0.0;  ///< N s/mm, of the mechanism (EnergyObserver); 0 if unknown
  double DeviceFriction = 0.0; ///< N, likewise
  bool HasMotors = true;       ///< false: faults of timing end by themselves
  WatchdogLimits Limits;
};

/// Input of a tick; everything in the device's frame.
struct SafetyInput
{
  TickObservation Observed;
  SafetyFault SceneFault = SafetyFault::None; ///< reported by the scene
  bool IsTouching = false;
  Vector3 ContactForce = Vector3::Zero();  ///< N
  Vector3 AmbientForce = Vector3::Zero();  ///< N, acts without contact too: gravity compensation
  Vector3 ContactTorque = Vector3::Zero(); ///< N mm
};

/// Stands between everything that computes forces and the device; it cannot be switched off. In
/// this order: watchdog, non-finite guard, ramp, energy observer, limit, slew limit.
///
/// For any input its output is finite and no longer than MaximumForce. A torque passes the same: it
/// is scaled as the limit scales the force, and no longer than MaximumTorque. A fault gives 0 N at
/// once and for good, until Rearm; only without motors, faults of timing end by themselves
/// (FaultRecovery), and forces fade in. It passes no force before the device is Ready.
class SafetyChain
{
public:
  explicit SafetyChain(const SafetySettings& settings) noexcept;

  /// Once a tick: the force (N, device's frame) to apply.
  Vector3 Apply(const SafetyInput& input) noexcept;
  /// N mm, device's frame: of the last Apply, with its force.
  const Vector3& Torque() const noexcept { return this->AppliedTorque; }
  /// A fault detected while applying the force. The first one since arming remains, except that
  /// one that lasts replaces one that would end by itself.
  void Fail(SafetyFault fault) noexcept;
  /// Clears a fault, restarts and fades in.
  void Rearm() noexcept;
  /// After a pause between two ticks: resets motion and fades in. A fault remains.
  void Resume() noexcept;
  /// Fades in again, for a new scene.
  void FadeIn() noexcept;

  const SafetyReport& Report() const noexcept { return this->LastReport; }

private:
  void Judge(const SafetyInput& input) noexcept;
  SafetyFault FaultOf(const SafetyInput& input) noexcept;
  Vector3 Shape(const SafetyInput& input) noexcept;
  double PeriodBefore(const TickObservation& now) const noexcept;
  Twist PathBefore(const TickObservation& now) const noexcept;
  void KeepBooks(const TickObservation& now, const Twist& path, double period) noexcept;
  Vector3 Zero() noexcept;

  Watchdog Dog;
  FaultRecovery Recovery;
  NonFiniteGuard Guard;
  RampIn Ramp;
  EnergyObserver Energy;
  ForceLimit Limit;
  SlewLimit Slew;
  ForceLimit TorqueLimit;
  SlewLimit TorqueSlew;
  SafetyReport LastReport;
  VelocityEstimate Motion;  // mm/s
  VelocityEstimate Turning; // rad/s
  double TurnLength;        // mm
  double DeviceDamping;     // N s/mm
  double DeviceFriction;    // N
  TickObservation Last;
  bool HasLast = false;
  Vector3 Turned = Vector3::Zero();         // rad, the sum of all turns since the last reset
  Vector3 AppliedContact = Vector3::Zero(); // N, of the last tick, held since
  Vector3 AppliedTorque = Vector3::Zero();  // N mm, likewise
};
} // namespace palpate
