#include "Watchdog.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Ticks of one time still allow for a motion of some encoder counts.
constexpr double ShortestPeriod = 1e-4; // s

bool IsFinite(const DeviceSample& sample) noexcept
{
  return Vector3(sample.Position).allFinite() &&
         std::all_of(sample.Orientation.begin(), sample.Orientation.end(),
                     [](double number) { return std::isfinite(number); });
}
} // namespace

void Watchdog::Reset() noexcept
{
  this->HasLast = false;
  this->WasReady = false;
  this->TicksWithoutSample = 0;
}

bool Watchdog::IsTooFast(const TickObservation& now) const noexcept
{
  const double passed = 1e-9 * static_cast<double>(now.Sample.Time - this->Last.Sample.Time);
  const double way = (Vector3(now.Sample.Position) - Vector3(this->Last.Sample.Position)).norm();
  return !(way <= this->Limits.FastestMotion * std::max(passed, ShortestPeriod));
}

SafetyFault Watchdog::CheckDevice(const TickObservation& now) noexcept
{
  const bool isReady = now.State == DeviceState::Ready;
  if (now.State == DeviceState::Error || (this->WasReady && !isReady) ||
      (isReady && !now.HasSample))
  {
    return SafetyFault::DeviceFailed;
  }
  this->WasReady = isReady;
  return SafetyFault::None;
}

SafetyFault Watchdog::CheckSample(const TickObservation& now) noexcept
{
  if (!IsFinite(now.Sample))
  {
    return SafetyFault::NonFinitePosition;
  }
  const bool isNew = !this->HasLast || now.Sample.Sequence != this->Last.Sample.Sequence;
  this->TicksWithoutSample = isNew ? 0 : this->TicksWithoutSample + 1;
  if (this->TicksWithoutSample >= this->Limits.StaleTicks ||
      now.Tick.Started - now.Sample.Time > this->Limits.OldestSample)
  {
    return SafetyFault::StaleSample;
  }
  return this->HasLast && this->IsTooFast(now) ? SafetyFault::ImplausibleMotion : SafetyFault::None;
}

SafetyFault Watchdog::Check(const TickObservation& now) noexcept
{
  SafetyFault fault = this->CheckDevice(now);
  // Before it is ready, a device's samples mean nothing.
  if (fault != SafetyFault::None || now.State != DeviceState::Ready)
  {
    return fault;
  }
  fault = this->CheckSample(now);
  if (fault == SafetyFault::None && this->HasLast &&
      now.Tick.Started - this->Last.Tick.Started > this->Limits.LongestGap)
  {
    fault = SafetyFault::StalledTick;
  }
  this->Last = now;
  this->HasLast = true;
  return fault;
}
} // namespace palpate
