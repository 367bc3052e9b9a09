#include "LoopSchedule.h"

#include <algorithm>

namespace palpate
{
LoopSchedule::LoopSchedule(std::int64_t start, std::int64_t period) noexcept
    : Period(std::max<std::int64_t>(period, 1)), Next(start)
{
}

TickInfo LoopSchedule::Begin(std::int64_t now) noexcept
{
  const std::int64_t skipped = std::max<std::int64_t>(0, (now - this->Next) / this->Period);
  TickInfo tick;
  tick.Number = this->Ticks++;
  tick.Scheduled = this->Next + skipped * this->Period;
  tick.Started = now;
  tick.SkippedPeriods = static_cast<std::uint64_t>(skipped);
  tick.IsLate = skipped > 0 || now - tick.Scheduled > this->Period / 10;
  this->Next = tick.Scheduled + this->Period;
  return tick;
}
} // namespace palpate
