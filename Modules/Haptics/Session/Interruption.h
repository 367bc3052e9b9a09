#pragma once

#include <array>
#include <csignal>

namespace palpate
{
/// Requests to end the program: Ctrl-C (SIGINT), SIGTERM, SIGHUP, and SIGPIPE, the result of
/// writing to a closed pipe. While one of these objects exists they do not end the process by
/// themselves: WasAsked becomes true, and long operations end on their own, with 0 N on a device
/// that is then closed, and with complete files.
///
/// From the second request on there are no forces (EmergencyStop), even if an operation hangs. The
/// third ends the program at once, if it takes too long to end; while an EndBeforeExit is in force,
/// the fifth does, after which a device's guard process sends 0 N. A SIGPIPE does not count for
/// this. Signals that the program's parent ignores (nohup) stay ignored.
///
/// Ctrl-Z (SIGTSTP), and reading from or writing to a terminal in the background (SIGTTIN,
/// SIGTTOU), stop the program as usual, but not while an EndBeforeExit is in force: a stopped
/// program would leave its last force on the device. Writing then succeeds, and reading fails.
class Interruption
{
public:
  /// Clears earlier requests.
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  /// Restores the previous signal handlers; WasAsked and ExitCode keep their values.
  ~Interruption();

  static bool WasAsked() noexcept;
  /// Exit status that shells expect of a program ended by the signal: 128 and its number (Ctrl-C:
  /// 130, SIGHUP: 129, SIGPIPE: 141, SIGTERM: 143); 0 without a request. The first of several.
  static int ExitCode() noexcept;

private:
  static constexpr std::array<int, 7> Signals{SIGINT,  SIGTERM, SIGHUP, SIGPIPE,
                                              SIGTSTP, SIGTTIN, SIGTTOU};
  std::array<struct sigaction, Signals.size()> Former{};
};
} // namespace palpate
