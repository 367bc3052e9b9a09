#pragma once

#include <cstdint>

namespace palpate
{
/// Time source of the servo; tests supply their own.
class Clock
{
public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  /// ns since an arbitrary start; never decreases.
  virtual std::int64_t Now() const noexcept = 0;
  /// ns since an arbitrary start, including time for which the machine was suspended, which Now()
  /// may not count. Returns Now() where the system has no such clock.
  virtual std::int64_t BootTime() const noexcept { return this->Now(); }
  /// Returns once Now() is `time` (ns) or later; immediately if it already is.
  virtual void WaitUntil(std::int64_t time) noexcept = 0;
};
} // namespace palpate
