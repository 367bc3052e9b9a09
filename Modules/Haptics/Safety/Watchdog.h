#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "LoopSchedule.h"
#include "SafetyReport.h"

namespace palpate
{
struct WatchdogLimits
{
  /// ns from one tick to the next, at least 1; also the longest suspension in between.
  std::int64_t LongestGap = 10'000'000;
  std::int64_t OldestSample = 10'000'000; ///< ns from its measurement to the tick, or after it
  int StaleTicks = 2;                     ///< consecutive ticks without a new sample
  double FastestMotion = 5000.0;          ///< mm/s; hands on a device stay below 2000
  double FastestTurn = 100.0;             ///< rad/s; wrists stay below 30
};

/// Input of a tick.
struct TickObservation
{
  TickInfo Tick;
  DeviceState State = DeviceState::Closed;
  bool HasSample = false; ///< the device returned one, perhaps the last one again
  DeviceSample Sample;
};

/// Checks time, device and samples, and reports the first sign of a failure.
class Watchdog
{
public:
  explicit Watchdog(const WatchdogLimits& limits) noexcept : Limits(limits) {}

  /// Once per tick, in order.
  SafetyFault Check(const TickObservation& now) noexcept;
  /// Forgets earlier ticks: the next one counts as the first.
  void Reset() noexcept;

private:
  SafetyFault CheckDevice(const TickObservation& now) noexcept;
  SafetyFault CheckSample(const TickObservation& now) noexcept;
  SafetyFault CheckTime(const TickInfo& now) const noexcept;
  bool IsTooFast(const TickObservation& now) const noexcept;

  WatchdogLimits Limits;
  TickObservation Last;
  bool HasLast = false;
  bool WasReady = false;
  int TicksWithoutSample = 0;
};
} // namespace palpate
