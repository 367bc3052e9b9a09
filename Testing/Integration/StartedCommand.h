#pragma once

#include "CommandRun.h"
#include "IsSoon.h"
#include "TemporaryFolder.h"

#include <sys/types.h>

namespace palpate::test
{
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
