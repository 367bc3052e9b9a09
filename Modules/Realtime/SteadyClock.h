#pragma once

#include "Clock.h"

namespace palpate
{
/// The machine's monotonic clock. Waiting sleeps until an absolute time; a scheduler wakes a thread
/// about ten microseconds late, so the last part may be spent spinning instead.
class SteadyClock final : public Clock
{
public:
  /// `spin` >= 0: how long (ns) before the end of a wait to stop sleeping and spin.
  explicit SteadyClock(std::int64_t spin = 0) noexcept : Spin(spin) {}

  std::int64_t Now() const noexcept override;
  /// CLOCK_BOOTTIME, if the system has it.
  std::int64_t BootTime() const noexcept override;
  void WaitUntil(std::int64_t time) noexcept override;

private:
  std::int64_t Spin; // ns
};
} // namespace palpate
