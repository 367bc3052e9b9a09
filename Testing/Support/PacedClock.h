#pragma once

#include "Clock.h"

#include <atomic>
#include <chrono>
#include <thread>

namespace palpate::test
{
/// Time that passes only while a thread waits for it, at most four times as fast as real time, so
/// that others keep up with what they see. On a busy machine a loop becomes slow but never late, so
/// the machine cannot cause stalls or stale samples.
class PacedClock final : public Clock
{
public:
  std::int64_t Now() const noexcept override { return this->Time.load(std::memory_order_acquire); }
  void WaitUntil(std::int64_t time) noexcept override
  {
    std::this_thread::sleep_for(std::chrono::nanoseconds((time - this->Now()) / 4));
    std::int64_t now = this->Now();
    while (now < time && !this->Time.compare_exchange_weak(now, time))
    {
    }
  }

private:
  std::atomic<std::int64_t> Time{0}; // ns
};
} // namespace palpate::test
