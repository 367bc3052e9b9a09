#pragma once

#include "FixedRateLoop.h"
#include "PeriodStatistics.h"
#include "RealtimeThread.h"
#include "Servo.h"

#include <memory>

namespace palpate
{
/// How a servo keeps its time.
struct ServoStatistics
{
  PeriodStatistics Periods;   ///< from one tick's start to the next's; misses are skipped periods
  PeriodStatistics Durations; ///< from a tick's start to its end; misses are late ticks
};

/// Runs a servo at its rate on a thread of its own, and without forces while an EmergencyStop is
/// ordered.
/// Start, Stop and the destructor are for the thread that owns it.
class ServoThread
{
public:
  /// Keeps the addresses of device and clock, which must outlive it. The device is open.
  ServoThread(HapticDevice& device, Clock& clock, const ServoSettings& settings);
  ~ServoThread() { this->Stop(); }
  ServoThread(const ServoThread&) = delete;
  ServoThread& operator=(const ServoThread&) = delete;

  /// Also after a Stop, however long ago: forces fade in, and a fault from before stays.
  Status Start(const RealtimeRequest& request);
  /// Returns after the last tick, with 0 N applied. Nothing where it does not run.
  void Stop();
  bool IsRunning() const noexcept { return this->Thread.IsJoinable(); }

  /// To publish scenes to, to read states from.
  Servo& Loop() noexcept { return this->Touch; }
  /// What the system granted at the last Start.
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
  // The servo thread's own.
  std::int64_t LastStarted = 0;
  ServoStatistics Counted;
  RealtimeThread Thread;
};
} // namespace palpate
