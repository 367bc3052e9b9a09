#pragma once

#include "Clock.h"
#include "LoopSchedule.h"

#include <atomic>

namespace palpate
{
/// Calls a function once per period, by LoopSchedule's rules, until it returns false or Stop is
/// called.
class FixedRateLoop
{
public:
  /// Keeps the address of the clock, which must outlive it; `period` > 0 (ns).
  FixedRateLoop(Clock& clock, std::int64_t period) noexcept : Time(clock), Period(period) {}

  /// Calls `tick(const TickInfo&)`, which must not throw, until it returns false or Stop is called
  /// (also before Run). Only one Run at a time.
  template <typename Tick>
  void Run(Tick&& tick)
  {
    LoopSchedule schedule(this->Time.Now(), this->Period);
    while (!this->IsStopped())
    {
      this->Time.WaitUntil(schedule.Deadline());
      if (this->IsStopped())
      {
        return;
      }
      TickInfo info = schedule.Begin(this->Time.Now());
      info.BootTime = this->Time.BootTime();
      if (!tick(info))
      {
        return;
      }
    }
  }

  /// No tick starts after the running one. Any thread.
  void Stop() noexcept { this->StopWanted.store(true, std::memory_order_release); }

private:
  bool IsStopped() const noexcept { return this->StopWanted.load(std::memory_order_acquire); }

  Clock& Time;
  std::int64_t Period;
  std::atomic<bool> StopWanted{false};
};
} // namespace palpate
