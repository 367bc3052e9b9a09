#pragma once

#include "Clock.h"

#include <atomic>

namespace palpate
{
/// Virtual time that passes only on request: waiting sets the clock to the end of the wait and
/// returns at once. For tests, and simulations that run as fast as possible. Other threads may read
/// it; only one at a time may advance it.
class ManualClock final : public Clock
{
public:
  explicit ManualClock(std::int64_t start = 0) noexcept : Time(start) {}

  std::int64_t Now() const noexcept override { return this->Time.load(std::memory_order_acquire); }
  std::int64_t BootTime() const noexcept override
  {
    return this->Now() + this->Suspended.load(std::memory_order_acquire);
  }
  void WaitUntil(std::int64_t time) noexcept override
  {
    if (time > this->Now())
    {
      this->Time.store(time, std::memory_order_release);
    }
  }
  /// Advances the time by `duration` >= 0 (ns).
  void Advance(std::int64_t duration) noexcept { this->Time.fetch_add(duration); }
  /// Suspends the machine for `duration` >= 0 (ns), which Now() does not count.
  void Suspend(std::int64_t duration) noexcept { this->Suspended.fetch_add(duration); }

private:
  std::atomic<std::int64_t> Time;         // ns
  std::atomic<std::int64_t> Suspended{0}; // ns
};
} // namespace palpate
