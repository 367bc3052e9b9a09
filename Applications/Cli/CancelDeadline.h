#pragma once

#include <condition_variable>
#include <mutex>
#include <thread>

namespace palpate::cli
{
class Console;

/// While it exists, a request to end the program (Interruption) is obeyed within half a second,
/// even if the work at hand does not react, like a factorisation in a library: then the program
/// ends at once, with the request's exit code. For work that writes no file and holds no device.
class CancelDeadline
{
public:
  /// Keeps the console's address.
  explicit CancelDeadline(Console& console);
  CancelDeadline(const CancelDeadline&) = delete;
  CancelDeadline& operator=(const CancelDeadline&) = delete;
  ~CancelDeadline();

private:
  void Watch();

  Console& Errors;
  std::mutex Mutex;
  std::condition_variable Changed;
  bool HasEnded = false; // the work
  std::thread Watcher;
};

/// Does the work under a deadline.
template <typename Work>
auto Cancellably(Console& console, const Work& work)
{
  const CancelDeadline deadline(console);
  return work();
}
} // namespace palpate::cli
