#pragma once

#include "CommandRun.h"
#include "TemporaryFolder.h"

#include <chrono>
#include <functional>
#include <sys/types.h>
#include <thread>

namespace palpate::test
{
/// Whether a condition became true before a deadline, which only a failing test reaches.
inline bool IsSoon(const std::function<bool()>& isTrue,
                   std::chrono::seconds longEnough = std::chrono::seconds(60))
{
  const auto end = std::chrono::steady_clock::now() + longEnough;
  while (!isTrue())
  {
    if (std::chrono::steady_clock::now() > end)
    {
      return false;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return true;
}

/// A running program, in its own process group like a shell's job: without a terminal, and with no
/// signal ignored.
class StartedCommand
{
public:
  enum class Errors
  {
    Kept,
    ReadByNobody ///< a pipe whose reader has closed
  };

  StartedCommand(const std::string& program, const std::vector<std::string>& arguments,
                 const std::filesystem::path& folder, Errors errors = Errors::Kept);
  /// Kills the processes that still run.
  ~StartedCommand();
  StartedCommand(const StartedCommand&) = delete;
  StartedCommand& operator=(const StartedCommand&) = delete;

  /// Sends a signal to the program's process group, as a terminal does.
  void Send(int signal) const;
  /// Whether no sent signal is still pending.
  bool HasTakenSignals() const;
  /// Whether it is stopped (SIGSTOP).
  bool IsStopped() const;
  bool HasEnded();
  /// Standard output so far.
  std::string OutputSoFar() const { return ReadAll(this->Streams / "out"); }
  /// Waits for its end.
  CommandRun Finish();

private:
  TemporaryFolder Streams;
  pid_t Child = 0;
  bool IsOver = false;
  int Outcome = 0; // of waitpid
};
} // namespace palpate::test
