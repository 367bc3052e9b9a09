#pragma once

#include "Clock.h"

#include <atomic>

namespace palpate
{
/// Virtual time, which passes only where it is told to: waiting sets the clock to the end of the
/// wait and returns at once. For tests and for simulations that run as fast as they can. Other
/// threads may read it; one at a time may move it.
class ManualClock final : public Clock
{
public:
  explicit ManualClock(std::int64_t start = 0) noexcept : Time(start) {}

  std::int64_t Now() const noexcept override { return this->Time.load(std::memory_order_acquire); }
  std::int64_t BootTime() const noexcept override
  {
    return this->Now() + this->Suspended.load(std::memory_order_acquire);
  }
  void WaitUntil(std::int64_t time) noexcept override;
  /// `duration` >= 0 (ns) passes.
  void Advance(std::int64_t duration) noexcept;
  /// The machine is suspended for `duration` >= 0 (ns), of which Now() does not know.
  void Suspend(std::int64_t duration) noexcept;

private:
  std::atomic<std::int64_t> Time;         // ns
  std::atomic<std::int64_t> Suspended{0}; // ns
};
} // namespace palpate
