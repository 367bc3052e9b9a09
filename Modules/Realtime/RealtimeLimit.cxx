#include "RealtimeLimit.h"

#include <algorithm>
#include <cerrno>

#include <csignal>
#include <sched.h>
#include <unistd.h>
#ifdef RLIMIT_RTTIME
#include <sys/syscall.h>
#endif

namespace palpate
{
#ifdef RLIMIT_RTTIME
namespace
{
// The kernel sends the signal to the thread that reached the limit, which 0 denotes here. The C
// library's wrappers must not be called in a signal handler.
extern "C" void Demote(int)
{
  const int error = errno;
  const sched_param none{};
  static_cast<void>(syscall(SYS_sched_setscheduler, 0, SCHED_OTHER, &none));
  errno = error;
}

bool IsHandledByDefault() noexcept
{
  struct sigaction action = {};
  return sigaction(SIGXCPU, nullptr, &action) == 0 && action.sa_handler == SIG_DFL;
}

bool Handle(void (*handler)(int)) noexcept
{
  struct sigaction action = {};
  action.sa_handler = handler;
  action.sa_flags = SA_RESTART;
  return sigaction(SIGXCPU, &action, nullptr) == 0;
}
} // namespace

RealtimeLimit::RealtimeLimit() noexcept
{
  this->HasHandler = IsHandledByDefault() && Handle(Demote);
  if (getrlimit(RLIMIT_RTTIME, &this->Former) == 0)
  {
    rlimit limit = this->Former;
    limit.rlim_cur = std::min<rlim_t>({limit.rlim_cur, limit.rlim_max, LongestRun});
    this->HasLimit = setrlimit(RLIMIT_RTTIME, &limit) == 0;
  }
}

RealtimeLimit::~RealtimeLimit()
{
  if (this->IsKept)
  {
    return;
  }
  if (this->HasLimit)
  {
    static_cast<void>(setrlimit(RLIMIT_RTTIME, &this->Former));
  }
  if (this->HasHandler)
  {
    static_cast<void>(Handle(SIG_DFL));
  }
}
#else
RealtimeLimit::RealtimeLimit() noexcept = default;
RealtimeLimit::~RealtimeLimit() = default;
#endif
} // namespace palpate
