#include "QuietStandardStreams.h"

#include <cstdio>
#include <fcntl.h>
#include <iostream>
#include <unistd.h>

namespace palpate
{
namespace
{
std::recursive_mutex& StreamsMutex()
{
  static std::recursive_mutex mutex;
  return mutex;
}

void FlushAll()
{
  std::cout.flush();
  std::cerr.flush();
  std::fflush(stdout);
  std::fflush(stderr);
}

// A duplicate of `descriptor` for restoring it, or -1 if it was closed.
int Mute(int descriptor)
{
  const int saved = fcntl(descriptor, F_DUPFD_CLOEXEC, 3);
  const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (saved >= 0 && nowhere >= 0)
  {
    dup2(nowhere, descriptor);
  }
  if (nowhere >= 0)
  {
    close(nowhere);
  }
  return saved;
}

void Restore(int saved, int descriptor)
{
  if (saved >= 0)
  {
    dup2(saved, descriptor);
    close(saved);
  }
}
} // namespace

QuietStandardStreams::QuietStandardStreams() : Lock(StreamsMutex())
{
  FlushAll();
  this->SavedOutput = Mute(STDOUT_FILENO);
  this->SavedErrors = Mute(STDERR_FILENO);
}

QuietStandardStreams::~QuietStandardStreams()
{
  FlushAll();
  Restore(this->SavedOutput, STDOUT_FILENO);
  Restore(this->SavedErrors, STDERR_FILENO);
}
} // namespace palpate
