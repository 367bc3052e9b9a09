#include "Interruption.h"

#include <csignal>

namespace palpate::cli
{
namespace
{
// A signal handler can reach nothing else.
volatile std::sig_atomic_t Asked = 0;

void Ask(int signal)
{
  Asked = 1;
  std::signal(signal, SIG_DFL);
}
} // namespace

Interruption::Interruption()
{
  Asked = 0;
  std::signal(SIGINT, Ask);
}

Interruption::~Interruption()
{
  std::signal(SIGINT, SIG_DFL);
}

bool Interruption::WasAsked() noexcept
{
  return Asked != 0;
}
} // namespace palpate::cli
