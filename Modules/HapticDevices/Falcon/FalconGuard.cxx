#include "FalconGuard.h"

#include "ChildProgram.h"

#include <sys/socket.h>
#include <unistd.h>

namespace palpate
{
namespace
{
constexpr const char* Program = "palpate-falcon-guard";
} // namespace

FalconGuard::~FalconGuard()
{
  if (this->HasCalled)
  {
    close(this->Socket);
    return;
  }
  this->Dismiss();
}

bool FalconGuard::Start(const std::string& busPath)
{
  this->Dismiss();
  int sockets[2] = {-1, -1};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, sockets) != 0)
  {
    return false;
  }
  this->Process = StartChildProgram(Program, {busPath}, sockets[1]);
  close(sockets[1]);
  if (this->Process < 0)
  {
    close(sockets[0]);
    return false;
  }
  this->Socket = sockets[0];
  this->HasCalled = false;
  return true;
}

void FalconGuard::Say(char word) const noexcept
{
  // Fails if the guard has ended, that is, has done its work.
  static_cast<void>(send(this->Socket, &word, 1, MSG_NOSIGNAL | MSG_DONTWAIT));
}

void FalconGuard::Call() noexcept
{
  if (this->IsRunning())
  {
    this->HasCalled = true;
    this->Say(Stop);
  }
}

void FalconGuard::Dismiss() noexcept
{
  if (!this->IsRunning())
  {
    return;
  }
  this->Say(Quit);
  close(this->Socket);
  this->Socket = -1;
  this->HasCalled = false;
  WaitForChildProgram(this->Process);
}
} // namespace palpate
