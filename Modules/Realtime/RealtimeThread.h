#pragma once

#include "Status.h"

#include <functional>
#include <string>
#include <thread>

namespace palpate
{
/// What a thread asks the operating system for.
struct RealtimeRequest
{
  int Priority = 80;        ///< of SCHED_FIFO, 1 to 99; 0 asks for none
  bool LocksMemory = false; ///< keeps what the process has by now from being paged out
};

/// What it got.
struct RealtimeGrant
{
  bool HasPriority = false;
  bool HasLockedMemory = false;
  std::string Advice; ///< one sentence for each wish that was refused: why, and what would help
};

/// A thread that asks for real-time scheduling and says what it was given; without the privilege it
/// runs as any other. One that stops sleeping loses the priority again (RealtimeLimit).
class RealtimeThread
{
public:
  RealtimeThread() = default;
  RealtimeThread(const RealtimeThread&) = delete;
  RealtimeThread& operator=(const RealtimeThread&) = delete;
  /// Waits for the body to end; its owner must have told it to.
  ~RealtimeThread() { this->Join(); }

  /// Runs `body`, which must not throw, on a new thread and returns when it is about to begin.
  /// Fails where a thread is running already or cannot be made.
  Status Start(const RealtimeRequest& request, std::function<void()> body);
  /// Waits for the body to end; nothing where none runs.
  void Join();

  bool IsJoinable() const noexcept { return this->Thread.joinable(); }
  /// Of the last Start.
  const RealtimeGrant& Grant() const noexcept { return this->Given; }

private:
  std::thread Thread;
  RealtimeGrant Given;
};
} // namespace palpate
