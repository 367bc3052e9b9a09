#include "Watchdog.h"

#include <algorithm>

namespace palpate
{
namespace
{
// Ticks at the same time still allow for a motion of some encoder counts.
constexpr double ShortestPeriod = 1e-4; // s

Eigen::Quaterniond OrientationOf(const DeviceSample& sample) noexcept
{
  return Eigen::Quaterniond(Eigen::Map<const Eigen::Quaterniond>(sample.Orientation.data()));
}
} // namespace

void Watchdog::Reset() noexcept
{
  this->HasLast = false;
  this->WasReady = false;
  this->TicksWithoutSample = 0;
}

// Too late, or the clock stopped or went back: it is unknown how long the force was held.
SafetyFault Watchdog::CheckTime(const TickInfo& now) const noexcept
{
  const std::int64_t passed = now.Started - this->Last.Tick.Started;
  const std::int64_t passedSinceBoot = now.BootTime - this->Last.Tick.BootTime;
  const std::int64_t longest = this->Limits.LongestGap;
  if (passedSinceBoot > longest && passed < passedSinceBoot - longest)
  {
    return SafetyFault::Suspended;
  }
  const bool isStalled = passed <= 0 || std::max(passed, passedSinceBoot) > longest;
  return isStalled ? SafetyFault::StalledTick : SafetyFault::None;
}

bool Watchdog::IsTooFast(const TickObservation& now) const noexcept
{
  const double passed = 1e-9 * static_cast<double>(now.Sample.Time - this->Last.Sample.Time);
  const double path = (Vector3(now.Sample.Position) - Vector3(this->Last.Sample.Position)).norm();
  const double turn = OrientationOf(now.Sample).angularDistance(OrientationOf(this->Last.Sample));
  const double period = std::max(passed, ShortestPeriod);
  return !(path <= this->Limits.FastestMotion * period) ||
         !(turn <= this->Limits.FastestTurn * period);
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
  if (!now.Sample.IsPose())
  {
    return SafetyFault::NonFinitePosition;
  }
  const bool isNew = !this->HasLast || now.Sample.Sequence != this->Last.Sample.Sequence;
  this->TicksWithoutSample = isNew ? 0 : this->TicksWithoutSample + 1;
  const std::int64_t age = now.Tick.Started - now.Sample.Time;
  // A sample from the future would never be old, and would allow any motion since the previous one.
  if (this->TicksWithoutSample >= this->Limits.StaleTicks || age > this->Limits.OldestSample ||
      age < -this->Limits.OldestSample)
  {
    return SafetyFault::StaleSample;
  }
  return this->HasLast && this->IsTooFast(now) ? SafetyFault::ImplausibleMotion : SafetyFault::None;
}

SafetyFault Watchdog::Check(const TickObservation& now) noexcept
{
  SafetyFault fault = this->CheckDevice(now);
  // Before a device is ready, its samples are not valid.
  if (fault != SafetyFault::None || now.State != DeviceState::Ready)
  {
    return fault;
  }
  const SafetyFault late = this->HasLast ? this->CheckTime(now.Tick) : SafetyFault::None;
  fault = this->CheckSample(now);
  // Samples are old after a suspension too, but not due to a failure of the device.
  if (fault == SafetyFault::None || late == SafetyFault::Suspended)
  {
    fault = late;
  }
  this->Last = now;
  this->HasLast = true;
  return fault;
}
} // namespace palpate
