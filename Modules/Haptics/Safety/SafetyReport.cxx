#include "SafetyReport.h"

namespace palpate
{
namespace
{
const char* DescribeLasting(SafetyFault fault) noexcept
{
  switch (fault)
  {
  case SafetyFault::None:
    return "Forces are on.";
  case SafetyFault::DeviceFailed:
    return "The device failed or was unplugged: check its cable and power, then open it again.";
  case SafetyFault::StalledTick:
    return "The servo was delayed for too long: close other programs or allow it real-time "
           "priority, then switch forces on again.";
  case SafetyFault::StaleSample:
    return "The device sends no new positions: check its cable, then switch forces on again.";
  case SafetyFault::ImplausibleMotion:
    return "The device reported a motion faster than any hand: home it, then switch forces "
           "on again.";
  case SafetyFault::NonFinitePosition:
    return "The device reported an invalid position: home it, then switch forces on "
           "again.";
  case SafetyFault::NonFiniteForce:
    return "A computed force was not finite or implausibly large: change the scene's stiffness or "
           "model, then switch forces on again.";
  case SafetyFault::InvalidContact:
    return "A model of the scene gave no valid contact: change the scene, then switch forces on "
           "again.";
  case SafetyFault::SwitchedOff:
    return "Forces were switched off: switch them on again when nothing is in the way.";
  case SafetyFault::Suspended:
    return "The machine was suspended: hold the handle, then switch forces on again.";
  case SafetyFault::UntakenForce:
    return "The device does not accept forces: close other programs or try another USB port, then "
           "switch forces on again.";
  }
  return "An unknown fault.";
}

// Of faults of timing; see FaultRecovery.
const char* DescribeResuming(SafetyFault fault) noexcept
{
  switch (fault)
  {
  case SafetyFault::StaleSample:
    return "The device sent no new positions: touching goes on by itself once it does.";
  case SafetyFault::Suspended:
    return "The machine was suspended: touching goes on by itself.";
  default:
    return "The servo was delayed for too long: touching goes on by itself.";
  }
}
} // namespace

const char* Describe(SafetyFault fault, bool willResume) noexcept
{
  return willResume ? DescribeResuming(fault) : DescribeLasting(fault);
}
} // namespace palpate
