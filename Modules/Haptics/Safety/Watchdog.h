#pragma once

#include "DeviceSample.h"
#include "DeviceState.h"
#include "LoopSchedule.h"
#include "SafetyReport.h"

namespace palpate
{
struct WatchdogLimits
{
  /// ns from one tick to the next, which is more than 0; also the most that is suspended between.
  std::int64_t LongestGap = 10'000'000;
  std::int64_t OldestSample = 10'000'000; ///< ns from its measurement to the tick, or after it
  int StaleTicks = 2;                     ///< as many ticks in a row without a new sample
  double FastestMotion = 5000.0;          ///< mm/s; hands on a device stay below 2000
};

/// What a tick begins with.
struct TickObservation
{
  TickInfo Tick;
  DeviceState State = DeviceState::Closed;
  bool HasSample = false; ///< the device gave one; it may be the last one again
  DeviceSample Sample;
};

/// Judges time, device and samples: says from its first sign on that one of them failed.
class Watchdog
{
public:
  explicit Watchdog(const WatchdogLimits& limits) noexcept : Limits(limits) {}

  /// Once a tick, in order.
  SafetyFault Check(const TickObservation& now) noexcept;
  /// Forgets what was before: the next tick is a first one.
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
