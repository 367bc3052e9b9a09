#pragma once

#include "FixedRateLoop.h"
#include "PeriodStatistics.h"
#include "RealtimeThread.h"
#include "Servo.h"

#include <memory>

namespace palpate
{
/// Timing of a servo.
struct ServoStatistics
{
  PeriodStatistics Periods;   ///< between starts of ticks; misses are skipped periods
  PeriodStatistics Durations; ///< from start to end of a tick; misses are late ticks
};

/// Runs a servo at its rate on its own thread, without forces while an EmergencyStop is ordered.
/// Start, Stop and the destructor: owner thread.
class ServoThread
{
public:
  /// Keeps the addresses of device and clock, which must outlive it. The device must be open.
  ServoThread(HapticDevice& device, Clock& clock, const ServoSettings& settings);
  ~ServoThread() { this->Stop(); }
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Also after a Stop of any length: forces fade in, and an earlier fault remains.
  Status Start(const RealtimeRequest& request);
  /// Returns after the last tick, with 0 N applied. No effect if not running.
  void Stop();
  bool IsRunning() const noexcept { return this->Thread.IsJoinable(); }

  /// For publishing scenes and reading states.
  Servo& Loop() noexcept { return this->Touch; }
  /// Real-time properties granted by the system at the last Start.
  const RealtimeGrant& Grant() const noexcept { return this->Thread.Grant(); }
  /// Since Start, at most some fifty ticks old; for one reading thread.
  const ServoStatistics& Statistics() noexcept { return this->Published.Latest(); }

private:
  bool Tick(const TickInfo& tick) noexcept;

  Servo Touch;
  LatestValue<ServoStatistics> Published;
  HapticDevice& Device;
  Clock& Time;
  std::unique_ptr<FixedRateLoop> Rate;
  ServoSettings Settings;
  // Used by the servo thread only.
  std::int64_t LastStarted = 0;
  ServoStatistics Counted;
  RealtimeThread Thread;
};
} // namespace palpate
