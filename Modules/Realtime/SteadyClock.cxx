#include "SteadyClock.h"

#include <cerrno>
#include <ctime>

namespace palpate
{
namespace
{
constexpr std::int64_t Second = 1'000'000'000; // ns

std::int64_t Read(clockid_t clock) noexcept
{
  timespec now{};
  clock_gettime(clock, &now);
  return std::int64_t{now.tv_sec} * Second + now.tv_nsec;
}
} // namespace

std::int64_t SteadyClock::Now() const noexcept
{
  return Read(CLOCK_MONOTONIC);
}

std::int64_t SteadyClock::BootTime() const noexcept
{
#ifdef CLOCK_BOOTTIME
  return Read(CLOCK_BOOTTIME);
#else
  return Read(CLOCK_MONOTONIC);
#endif
}

void SteadyClock::WaitUntil(std::int64_t time) noexcept
{
  if (time > this->Now())
  {
    timespec until{};
    until.tv_sec = static_cast<time_t>(time / Second);
    until.tv_nsec = static_cast<long>(time % Second);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR)
    {
    }
  }
}
} // namespace palpate
