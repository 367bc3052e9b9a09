#pragma once

#include <cstdint>

#include <sys/resource.h>

namespace palpate
{
/// Stops a real-time thread that never sleeps from occupying a core for ever: sets the process's
/// soft RLIMIT_RTTIME, and a handler of SIGXCPU that returns a thread that reaches it to ordinary
/// scheduling (see README).
///
/// A lower existing limit and an existing handler are kept. Does nothing where the system has no
/// such limit.
class RealtimeLimit
{
public:
  /// Longest time (us) that a thread may run under SCHED_FIFO without sleeping.
  static constexpr std::uint64_t LongestRun = 200'000;

  /// Sets the limit and the handler.
  RealtimeLimit() noexcept;
  RealtimeLimit(const RealtimeLimit&) = delete;
  RealtimeLimit& operator=(const RealtimeLimit&) = delete;
  /// Restores the former limit and handler, unless Keep was called.
  ~RealtimeLimit();

  /// Keeps the limit for the process; call it when real-time priority was granted.
  void Keep() noexcept { this->IsKept = true; }

private:
  rlimit Former{};
  bool HasLimit = false;
  bool HasHandler = false;
  bool IsKept = false;
};
} // namespace palpate
