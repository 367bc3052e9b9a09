#pragma once

#include "Status.h"

#include <functional>
#include <string>
#include <thread>

namespace palpate
{
/// What a thread requests from the operating system.
struct RealtimeRequest
{
  int Priority = 80; ///< of SCHED_FIFO, 1 to 99; 0: none
};

/// What was granted.
struct RealtimeGrant
{
  bool HasPriority = false;
  std::string Advice; ///< for a refused request: the reason, and what would help
};

/// A thread that requests real-time scheduling and reports what was granted; without the privilege
/// it runs with ordinary scheduling. If it stops sleeping it loses the priority (RealtimeLimit).
class RealtimeThread
{
public:
  RealtimeThread() = default;
  RealtimeThread(const RealtimeThread&) = delete;
  RealtimeThread& operator=(const RealtimeThread&) = delete;
  /// Waits for the body to end; the owner must have told it to.
  ~RealtimeThread() { this->Join(); }

  /// Runs `body`, which must not throw, on a new thread; returns just before it begins. Fails if a
  /// thread is already running or cannot be created.
  Status Start(const RealtimeRequest& request, std::function<void()> body);
  /// Waits for the body to end; does nothing if no thread runs.
  void Join();

  bool IsJoinable() const noexcept { return this->Thread.joinable(); }
  /// Result of the last Start.
  const RealtimeGrant& Grant() const noexcept { return this->Given; }

private:
  std::thread Thread;
  RealtimeGrant Given;
};
} // namespace palpate
