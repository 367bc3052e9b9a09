#pragma once

#include "PalpateSessionModule.h"

#include <array>
#include <csignal>

namespace palpate
{
/// Requests to end the program: Ctrl-C (SIGINT), SIGTERM, SIGHUP, and SIGPIPE, which comes of
/// writing to somebody who no longer reads. While one of these objects exists they end nothing by
/// themselves: WasAsked becomes true, and whoever works ends by itself, with 0 N on a device that
/// is then closed, and with files that are whole.
///
/// The second request changes nothing. The third ends the program at once, for users of what takes
/// too long to end, but not while an EndBeforeExit is in force. Signals that the program's parent
/// wants ignored (nohup) stay ignored.
///
/// Ctrl-Z (SIGTSTP) stops the program as ever, but not while an EndBeforeExit is in force: a
/// stopped program would leave its last force on the device.
class PALPATESESSION_EXPORT Interruption
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
  struct sigaction FormerStop = {};
};
} // namespace palpate
