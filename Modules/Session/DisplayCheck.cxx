#include "DisplayCheck.h"

#include <cstdlib>
#include <stdexcept>
#include <string>

#include <X11/Xlib.h>

namespace palpate
{
namespace
{
bool HasOpenGL(const char* name)
{
  Display* display = XOpenDisplay(name);
  if (display == nullptr)
  {
    return false;
  }
  int opcode = 0;
  int event = 0;
  int error = 0;
  const bool isThere = XQueryExtension(display, "GLX", &opcode, &event, &error) == True;
  XCloseDisplay(display);
  return isThere;
}
} // namespace

void RequireDisplay()
{
  const char* name = std::getenv("DISPLAY");
  if (name == nullptr || *name == '\0')
  {
    throw std::runtime_error("drawing needs an X server with OpenGL, and DISPLAY names none; on a "
                             "machine without a screen, run the same command under xvfb-run -a");
  }
  if (!HasOpenGL(name))
  {
    throw std::runtime_error(
        "drawing needs an X server with OpenGL, and DISPLAY=" + std::string(name) +
        " does not answer or has none; run the same command under xvfb-run -a");
  }
}
} // namespace palpate
