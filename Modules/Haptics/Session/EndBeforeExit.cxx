#include "EndBeforeExit.h"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
// Global, since exit() passes no objects.
std::atomic<int> Count{0};

std::vector<EndBeforeExit*>& Known()
{
  static std::vector<EndBeforeExit*> all;
  return all;
}
} // namespace

EndBeforeExit::EndBeforeExit(std::function<void()> end) : End(std::move(end))
{
  Known().push_back(this);
  // After the list, so that it runs before the list is destroyed.
  static const int Registered = std::atexit(EndAll);
  static_cast<void>(Registered);
  ++Count;
}

EndBeforeExit::~EndBeforeExit()
{
  std::vector<EndBeforeExit*>& all = Known();
  all.erase(std::remove(all.begin(), all.end(), this), all.end());
  --Count;
}

bool EndBeforeExit::IsInForce() noexcept
{
  return Count > 0;
}

// The newest first. Each may remove others.
void EndBeforeExit::EndAll()
{
  while (!Known().empty())
  {
    const std::function<void()> end = std::move(Known().back()->End);
    Known().pop_back();
    end();
  }
}
} // namespace palpate
