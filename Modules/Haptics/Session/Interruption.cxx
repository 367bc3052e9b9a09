#include "Interruption.h"

#include "EmergencyStop.h"
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
constexpr int RequestsForNoForce = 2;
constexpr int MostRequests = 3;
constexpr int MostWhileForced = 5;

extern "C" void Ask(int signal)
{
  int none = 0;
  FirstSignal.compare_exchange_strong(none, signal);
  // Every further write to a closed pipe sends one, without a user's request.
  if (signal == SIGPIPE)
  {
    return;
  }
  const int requests = ++Requests;
  if (requests >= RequestsForNoForce)
  {
    EmergencyStop::Order();
  }
  if (requests >= (EndBeforeExit::IsInForce() ? MostWhileForced : MostRequests))
  {
    _exit(CodeOfSignals + signal);
  }
}

extern "C" void StopUnlessForced(int signal)
{
  if (!EndBeforeExit::IsInForce())
  {
    kill(getpid(), SIGSTOP);
  }
  else if (signal != SIGTSTP)
  {
    // Otherwise the same call would be repeated, and send it, forever.
    std::signal(signal, SIG_IGN);
  }
}
} // namespace

Interruption::Interruption()
{
  FirstSignal = 0;
  Requests = 0;
  EmergencyStop::Forget();
  struct sigaction action = {};
  action.sa_flags = SA_RESTART;
  for (std::size_t s = 0; s < Signals.size(); ++s)
  {
    const bool isStop = Signals[s] == SIGTSTP || Signals[s] == SIGTTIN || Signals[s] == SIGTTOU;
    action.sa_handler = isStop ? StopUnlessForced : Ask;
    sigaction(Signals[s], nullptr, &this->Former[s]);
    if (this->Former[s].sa_handler != SIG_IGN)
    {
      sigaction(Signals[s], &action, nullptr);
    }
  }
}

Interruption::~Interruption()
{
  for (std::size_t s = 0; s < Signals.size(); ++s)
  {
    sigaction(Signals[s], &this->Former[s], nullptr);
  }
  EmergencyStop::Forget();
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
