#include "DisplayServer.h"

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fcntl.h>
#include <poll.h>
#include <stdexcept>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <X11/Xlib.h>

namespace palpate
{
namespace
{
constexpr int StartTimeoutMilliseconds = 20000;

// Runs in the child between fork and exec: only async-signal-safe calls.
[[noreturn]] void BecomeServer(const char* displayDescriptor)
{
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  setsid(); // a terminal's Ctrl-C is not for the server, which ends with this process
  const int nothing = open("/dev/null", O_RDWR);
  dup2(nothing, STDIN_FILENO);
  dup2(nothing, STDOUT_FILENO);
  dup2(nothing, STDERR_FILENO);
  execlp("Xvfb", "Xvfb", "-displayfd", displayDescriptor, "-screen", "0", "1280x1024x24",
         "-noreset", "-nolisten", "tcp", static_cast<char*>(nullptr));
  _exit(127);
}

// The line that the server writes once it listens; empty where it ends or says nothing in time.
std::string ReadLine(int descriptor)
{
  std::string line;
  pollfd waiting{descriptor, POLLIN, 0};
  while (true)
  {
    const int ready = poll(&waiting, 1, StartTimeoutMilliseconds);
    if (ready < 0 && errno == EINTR)
    {
      continue;
    }
    char letter = 0;
    if (ready <= 0 || read(descriptor, &letter, 1) != 1)
    {
      return {};
    }
    if (letter == '\n')
    {
      return line;
    }
    line += letter;
  }
}
} // namespace

bool DisplayServer::CanReachDisplay()
{
  if (std::getenv("DISPLAY") == nullptr)
  {
    return false;
  }
  Display* display = XOpenDisplay(nullptr);
  if (display == nullptr)
  {
    return false;
  }
  int opcode = 0;
  int event = 0;
  int error = 0;
  const bool hasOpenGL = XQueryExtension(display, "GLX", &opcode, &event, &error) == True;
  XCloseDisplay(display);
  return hasOpenGL;
}

DisplayServer::DisplayServer()
{
  if (CanReachDisplay())
  {
    return;
  }
  this->Start();
  if (!CanReachDisplay())
  {
    this->Stop();
    throw std::runtime_error("drawing needs an X server with OpenGL, and the Xvfb that was started "
                             "has none; install libgl1-mesa-dri");
  }
}

DisplayServer::~DisplayServer()
{
  this->Stop();
}

void DisplayServer::Start()
{
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0)
  {
    throw std::runtime_error("no pipe can be made to start an X server; close some programs");
  }
  fcntl(ends[0], F_SETFD, FD_CLOEXEC);
  const std::string descriptor = std::to_string(ends[1]);
  const pid_t child = fork();
  if (child == 0)
  {
    BecomeServer(descriptor.c_str());
  }
  close(ends[1]);
  const std::string number = child > 0 ? ReadLine(ends[0]) : std::string();
  close(ends[0]);
  this->Process = child > 0 ? child : 0;
  if (number.empty())
  {
    this->Stop();
    throw std::runtime_error("drawing needs an X server, and none can be reached or started; set "
                             "DISPLAY, or install Xvfb (apt-get install xvfb)");
  }
  if (const char* former = std::getenv("DISPLAY"))
  {
    this->HadDisplay = true;
    this->FormerDisplay = former;
  }
  setenv("DISPLAY", (":" + number).c_str(), 1);
}

void DisplayServer::Stop()
{
  if (!this->IsPrivate())
  {
    return;
  }
  kill(this->Process, SIGTERM);
  while (waitpid(this->Process, nullptr, 0) < 0 && errno == EINTR)
  {
  }
  this->Process = 0;
  if (this->HadDisplay)
  {
    setenv("DISPLAY", this->FormerDisplay.c_str(), 1);
  }
  else
  {
    unsetenv("DISPLAY");
  }
}
} // namespace palpate
