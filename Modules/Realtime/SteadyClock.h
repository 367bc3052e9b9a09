#pragma once

#include "Clock.h"

namespace palpate
{
/// The machine's monotonic clock. Waiting sleeps to an absolute time; a scheduler wakes a thread
/// some ten microseconds late, so the last part may be spent spinning instead.
class SteadyClock final : public Clock
{
public:
  /// `spin` >= 0: how long (ns) before the end of a wait it stops sleeping and keeps a core busy.
  explicit SteadyClock(std::int64_t spin = 0) noexcept : Spin(spin) {}

  std::int64_t Now() const noexcept override;
  /// CLOCK_BOOTTIME, where the system has it.
  std::int64_t BootTime() const noexcept override;
  void WaitUntil(std::int64_t time) noexcept override;

private:
  std::int64_t Spin; // ns
};
} // namespace palpate
