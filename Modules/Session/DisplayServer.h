#pragma once

#include "PalpateSessionModule.h"

#include <string>
#include <sys/types.h>

namespace palpate
{
/// An X server that OpenGL can draw with, for as long as the object lives. VTK as Debian builds it
/// ends the process where there is none, so one of these comes before any render window.
///
/// The server of DISPLAY is used where it answers and has GLX. Otherwise a private Xvfb is started
/// on a free display, DISPLAY names it meanwhile, and it ends with the object or with the process.
/// Make it in the main thread: the environment is changed.
class PALPATESESSION_EXPORT DisplayServer
{
public:
  /// Throws std::runtime_error with a sentence where neither is possible.
  DisplayServer();
  DisplayServer(const DisplayServer&) = delete;
  DisplayServer& operator=(const DisplayServer&) = delete;
  ~DisplayServer();

  /// Whether a private server was started.
  bool IsPrivate() const { return this->Process > 0; }

  /// Whether the server that DISPLAY names answers and has GLX.
  static bool CanReachDisplay();

private:
  void Start();
  void Stop();

  pid_t Process = 0;
  bool HadDisplay = false;
  std::string FormerDisplay;
};
} // namespace palpate
