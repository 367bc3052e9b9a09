#include "DisplayCheck.h"

#include <cstdlib>
#include <map>
#include <stdexcept>
#include <string>

#include <X11/Xlib.h>

namespace palpate
{
namespace
{
// The connection stays open to the end of the process: a server without -noreset, as started by
// xvfb-run, restarts when its last client leaves, and the window's connection would hit that
// restart.
bool HasOpenGL(const std::string& name)
{
  static std::map<std::string, Display*> connections;
  if (connections.count(name) > 0)
  {
    return true;
  }
  Display* display = XOpenDisplay(name.c_str());
  if (display == nullptr)
  {
    return false;
  }
  int opcode = 0;
  int event = 0;
  int error = 0;
  if (XQueryExtension(display, "GLX", &opcode, &event, &error) != True)
  {
    XCloseDisplay(display);
    return false;
  }
  connections.emplace(name, display);
  return true;
}
} // namespace

void RequireDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0')
  {
    throw std::runtime_error("drawing needs an X server with OpenGL, but DISPLAY names none; on a "
                             "machine without a screen, run the same command under xvfb-run -a");
  }
  if (!HasOpenGL(name))
  {
    throw std::runtime_error(
        "drawing needs an X server with OpenGL, but DISPLAY=" + std::string(name) +
        " does not answer or has no OpenGL; run the same command under xvfb-run -a");
  }
}
} // namespace palpate
