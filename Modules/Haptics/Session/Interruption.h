#pragma once

#include <array>
#include <csignal>

namespace palpate
{
/// Requests to end the program: Ctrl-C (SIGINT), SIGTERM, SIGHUP, and SIGPIPE, which comes of
/// writing to somebody who no longer reads. While one of these objects exists they end nothing by
/// themselves: WasAsked becomes true, and whoever works ends by itself, with 0 N on a device that
/// is then closed, and with files that are whole.
///
/// From the second request on there are no forces (EmergencyStop), even where who works hangs. The
/// third ends the program at once, for users of what takes too long to end; while an EndBeforeExit
/// is in force it takes the fifth, after which a device's guard process sends 0 N. A SIGPIPE counts
/// for none of this. Signals that the program's parent wants ignored (nohup) stay ignored.
///
/// Ctrl-Z (SIGTSTP), and reading from or writing to a terminal in the background (SIGTTIN,
/// SIGTTOU), stop the program as ever, but not while an EndBeforeExit is in force: a stopped
/// program would leave its last force on the device. What is written then is written, and reading
/// fails.
class Interruption
{
public:
  /// From now on nobody has asked.
  Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;
  /// Signals do what they did before; WasAsked and ExitCode stay.
  ~Interruption();

  static bool WasAsked() noexcept;
  /// What shells expect of a program that such a signal ends: 128 and its number (Ctrl-C: 130,
  /// SIGHUP: 129, SIGPIPE: 141, SIGTERM: 143); 0 where nobody asked. Of more than one, the first.
  static int ExitCode() noexcept;

private:
  static constexpr std::array<int, 4> Signals{SIGINT, SIGTERM, SIGHUP, SIGPIPE};
  std::array<struct sigaction, Signals.size()> Former{};
  static constexpr std::array<int, 3> Stops{SIGTSTP, SIGTTIN, SIGTTOU};
  std::array<struct sigaction, Stops.size()> FormerStops{};
};
} // namespace palpate
