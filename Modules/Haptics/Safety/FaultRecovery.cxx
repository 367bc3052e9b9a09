#include "FaultRecovery.h"

namespace palpate
{
namespace
{
bool IsOfTiming(SafetyFault fault) noexcept
{
  switch (fault)
  {
  case SafetyFault::StalledTick: // the machine was busy; what the tick computes from is right
  case SafetyFault::StaleSample: // likewise: a computed device is as late as the thread it runs in
  case SafetyFault::Suspended:   // the machine slept, and the hand was away
    return true;
  case SafetyFault::None:
  case SafetyFault::SwitchedOff:       // a person decided
  case SafetyFault::DeviceFailed:      // it has to be opened again
  case SafetyFault::UntakenForce:      // the device does not work
  case SafetyFault::ImplausibleMotion: // positions are wrong, and may stay so unnoticed
  case SafetyFault::NonFinitePosition: // likewise
  case SafetyFault::NonFiniteForce:    // the scene has a defect, which the same place shows again
  case SafetyFault::InvalidContact:    // likewise
    return false;
  }
  return false;
}
} // namespace

bool FaultRecovery::EndsByItself(SafetyFault fault) const noexcept
{
  return !this->HasMotors && IsOfTiming(fault);
}

bool FaultRecovery::IsOver(std::int64_t time) noexcept
{
  this->Since = this->IsWaiting ? this->Since : time;
  this->IsWaiting = true;
  return time - this->Since >= Wait;
}
} // namespace palpate
