#include "ManualClock.h"

namespace palpate
{
void ManualClock::WaitUntil(std::int64_t time) noexcept
{
  if (time > this->Now())
  {
    this->Time.store(time, std::memory_order_release);
  }
}

void ManualClock::Advance(std::int64_t duration) noexcept
{
  this->Time.fetch_add(duration, std::memory_order_acq_rel);
}

void ManualClock::Suspend(std::int64_t duration) noexcept
{
  this->Suspended.fetch_add(duration, std::memory_order_acq_rel);
}
} // namespace palpate
