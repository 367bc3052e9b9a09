#pragma once

#include <cstdint>

namespace palpate
{
/// Time as the servo sees it, so that tests can give it their own.
class Clock
{
public:
  Clock() = default;
  Clock(const Clock&) = delete;
  Clock& operator=(const Clock&) = delete;
  virtual ~Clock() = default;

  /// ns since an arbitrary start; never falls.
  virtual std::int64_t Now() const noexcept = 0;
  /// ns since an arbitrary start by a clock that goes on while the machine is suspended, which
  /// Now() need not. Where the system has no such clock, Now().
  virtual std::int64_t BootTime() const noexcept { return this->Now(); }
  /// Returns once Now() is `time` (ns) or later; at once where it already is.
  virtual void WaitUntil(std::int64_t time) noexcept = 0;
};
} // namespace palpate
