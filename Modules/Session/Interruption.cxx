#include "Interruption.h"

#include "EndBeforeExit.h"

#include <atomic>
#include <cstddef>

#include <unistd.h>

namespace palpate
{
namespace
{
// A signal handler can reach nothing else.
std::atomic<int> FirstSignal{0};
std::atomic<int> Requests{0};
static_assert(std::atomic<int>::is_always_lock_free);

constexpr int CodeOfSignals = 128;
constexpr int MostRequests = 3;

extern "C" void Ask(int signal)
{
  int none = 0;
  FirstSignal.compare_exchange_strong(none, signal);
  // Every further write to a closed pipe sends one, which is nobody's wish.
  if (signal != SIGPIPE && ++Requests >= MostRequests && !EndBeforeExit::IsInForce())
  {
    _exit(CodeOfSignals + signal);
  }
}

extern "C" void StopUnlessForced(int)
{
  if (!EndBeforeExit::IsInForce())
  {
    kill(getpid(), SIGSTOP);
  }
}
} // namespace

Interruption::Interruption()
{
  FirstSignal = 0;
  Requests = 0;
  struct sigaction action = {};
  action.sa_handler = Ask;
  action.sa_flags = SA_RESTART;
  for (std::size_t s = 0; s < Signals.size(); ++s)
  {
    sigaction(Signals[s], nullptr, &this->Former[s]);
    if (this->Former[s].sa_handler != SIG_IGN)
    {
      sigaction(Signals[s], &action, nullptr);
    }
  }
  sigaction(SIGTSTP, nullptr, &this->FormerStop);
  if (this->FormerStop.sa_handler != SIG_IGN)
  {
    action.sa_handler = StopUnlessForced;
    sigaction(SIGTSTP, &action, nullptr);
  }
}

Interruption::~Interruption()
{
  for (std::size_t s = 0; s < Signals.size(); ++s)
  {
    sigaction(Signals[s], &this->Former[s], nullptr);
  }
  sigaction(SIGTSTP, &this->FormerStop, nullptr);
}

bool Interruption::WasAsked() noexcept
{
  return FirstSignal != 0;
}

int Interruption::ExitCode() noexcept
{
  const int signal = FirstSignal;
  return signal != 0 ? CodeOfSignals + signal : 0;
}
} // namespace palpate
