#pragma once

namespace palpate
{
/// Why forces are off.
enum class SafetyFault
{
  None,
  DeviceFailed,
  StalledTick,
  StaleSample,
  ImplausibleMotion,
  NonFinitePosition,
  NonFiniteForce,
  InvalidContact,
  SwitchedOff, ///< by a person
  Suspended,   ///< the machine slept between two ticks
  UntakenForce ///< the device is present but accepted no force for too long
};

/// What a safety chain did in the last tick.
struct SafetyReport
{
  SafetyFault Fault = SafetyFault::None; ///< the first one since it was armed
  bool IsArmed = false;                  ///< the device is ready and there is no fault
  bool IsRamping = false;                ///< forces are still being faded in
  bool IsDamping = false;                ///< the contact gave out more energy than it took in
  bool IsLimited = false;                ///< cut to the largest force
  bool IsSlewing = false;                ///< the change was cut to the largest in one tick
  double Energy = 0.0;                   ///< N mm that the contact took in since it began
};

/// One sentence for the person at the device: what happened and what to do.
const char* Describe(SafetyFault fault) noexcept;
} // namespace palpate
