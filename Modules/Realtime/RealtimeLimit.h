#pragma once

#include <cstdint>

#include <sys/resource.h>

namespace palpate
{
/// Keeps a real-time thread that never sleeps from holding a core for ever: sets the process's soft
/// RLIMIT_RTTIME, and a handler of SIGXCPU by which a thread that reaches it goes on with ordinary
/// scheduling. By default the signal would end the process, with whatever force is on the motors.
///
/// A lower limit, and a handler that the program has already, stay. Where the system has no such
/// limit this does nothing.
class RealtimeLimit
{
public:
  /// us that a thread may run under SCHED_FIFO without sleeping. The value of rtkit, twenty times
  /// the gap between ticks at which forces are off anyway.
  static constexpr std::uint64_t LongestRun = 200'000;

  /// Sets both.
  RealtimeLimit() noexcept;
  RealtimeLimit(const RealtimeLimit&) = delete;
  RealtimeLimit& operator=(const RealtimeLimit&) = delete;
  /// Puts back what was there before, unless Keep was called.
  ~RealtimeLimit();

  /// Real-time priority was granted: the limit stays for the process.
  void Keep() noexcept { this->IsKept = true; }

private:
  rlimit Former{};
  bool HasLimit = false;
  bool HasHandler = false;
  bool IsKept = false;
};
} // namespace palpate
