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
  SwitchedOff, ///< by the user
  Suspended,   ///< the machine was suspended between two ticks
  UntakenForce ///< the device is present but accepted no force for too long
};

/// Result of a safety chain's last tick.
struct SafetyReport
{
  SafetyFault Fault = SafetyFault::None; ///< the first one; see SafetyChain::Fail
  bool IsArmed = false;                  ///< the device is ready and there is no fault
  bool IsRamping = false;                ///< forces are still being faded in
  bool IsDamping = false;                ///< the contact returned more energy than it absorbed
  bool IsLimited = false;                ///< reduced to the largest force
  bool IsSlewing = false;                ///< the change was reduced to the largest per tick
  bool WillResume = false;               ///< the fault ends by itself, after FaultRecovery::Wait
  double Energy = 0.0;                   ///< N mm that the contact absorbed since it began
};

/// Message for the user: what happened and what to do; nothing if the fault ends by itself
/// (SafetyReport::WillResume).
const char* Describe(SafetyFault fault, bool willResume = false) noexcept;
} // namespace palpate
