#pragma once

#include <cstdint>

namespace palpate
{
/// Timing of one tick of a loop, in ns of the loop's clock.
struct TickInfo
{
  std::uint64_t Number = 0;         ///< counts the ticks that ran, from 0
  std::int64_t Scheduled = 0;       ///< when it should have started
  std::int64_t Started = 0;         ///< when it did
  std::int64_t BootTime = 0;        ///< when it did, by a clock that counts suspended time
  std::uint64_t SkippedPeriods = 0; ///< deadlines between the last tick and this one without a tick
  bool IsLate = false;              ///< started more than a tenth of a period after its deadline
};

/// The deadlines of a loop at a fixed rate: multiples of the period after its start, however long
/// ticks take. A tick whose deadline has just passed runs at once; deadlines that a whole period or
/// more has passed since are skipped, so that a delayed loop does not try to catch up.
class LoopSchedule
{
public:
  /// The first tick is due at `start`; `period` > 0. ns.
  LoopSchedule(std::int64_t start, std::int64_t period) noexcept;

  /// Start time of the next tick.
  std::int64_t Deadline() const noexcept { return this->Next; }
  /// Starts the tick at `now`, which must not be before the deadline.
  TickInfo Begin(std::int64_t now) noexcept;

private:
  std::int64_t Period;
  std::int64_t Next;
  std::uint64_t Ticks = 0;
};
} // namespace palpate
