#pragma once

#include "Clock.h"

namespace palpate
{
/// The machine's monotonic clock. Waiting sleeps until an absolute time; a scheduler wakes a thread
/// about ten microseconds late.
class SteadyClock final : public Clock
{
public:
  std::int64_t Now() const noexcept override;
  /// CLOCK_BOOTTIME, if the system has it.
  std::int64_t BootTime() const noexcept override;
  void WaitUntil(std::int64_t time) noexcept override;
};
} // namespace palpate
