#include "CancelDeadline.h"

#include "Console.h"
#include "Interruption.h"

#include <chrono>
#include <cstdlib>

namespace palpate::cli
{
CancelDeadline::CancelDeadline(Console& console)
    : Errors(console), Watcher([this] { this->Watch(); })
{
}

CancelDeadline::~CancelDeadline()
{
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->HasEnded = true;
  }
  this->Changed.notify_all();
  this->Watcher.join();
}

void CancelDeadline::Watch()
{
  constexpr std::chrono::milliseconds Glance(50);
  constexpr std::chrono::milliseconds Patience(400); // of the work's own reaction
  std::unique_lock<std::mutex> lock(this->Mutex);
  const auto hasEnded = [this] { return this->HasEnded; };
  while (!Interruption::WasAsked())
  {
    if (this->Changed.wait_for(lock, Glance, hasEnded))
    {
      return;
    }
  }
  if (!this->Changed.wait_for(lock, Patience, hasEnded))
  {
    this->Errors.Error("cancelled; what was finished is kept");
    std::_Exit(Interruption::ExitCode());
  }
}
} // namespace palpate::cli
