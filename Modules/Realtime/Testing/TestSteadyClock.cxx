#include "ManualClock.h"
#include "SteadyClock.h"

#include <gtest/gtest.h>

namespace palpate::steady_clock_test
{
namespace
{
TEST(SteadyClock, WaitsEndNoEarlierThanRequested)
{
  SteadyClock clock;
  for (int i = 0; i < 20; ++i)
  {
    const std::int64_t until = clock.Now() + 100'000;
    clock.WaitUntil(until);
    EXPECT_GE(clock.Now(), until);
  }
}

TEST(SteadyClock, PastTimesReturnAtOnce)
{
  SteadyClock clock;
  clock.WaitUntil(INT64_MIN / 2);
  clock.WaitUntil(clock.Now() - 1);
}

// The second of two readings of one clock with another reading between them is not before the
// first.
TEST(SteadyClock, BootTimeIsNeverBehindNow)
{
  const SteadyClock clock;
  const std::int64_t before = clock.Now();
  const std::int64_t first = clock.BootTime();
  EXPECT_GE(first, before);
  const std::int64_t second = clock.BootTime();
  EXPECT_GE(second, first);
  SteadyClock waiting;
  waiting.WaitUntil(waiting.Now() + 2'000'000);
  EXPECT_GE(clock.BootTime() - second, 2'000'000);
}

TEST(ManualClock, OnlyBootTimeCountsSuspension)
{
  ManualClock clock(5);
  EXPECT_EQ(clock.BootTime(), 5);
  clock.Suspend(1000);
  EXPECT_EQ(clock.Now(), 5);
  EXPECT_EQ(clock.BootTime(), 1005);
  clock.Advance(2);
  EXPECT_EQ(clock.BootTime(), 1007);
}

TEST(ManualClock, MovesOnlyForwardOnRequest)
{
  ManualClock clock(5);
  clock.WaitUntil(9);
  EXPECT_EQ(clock.Now(), 9);
  clock.WaitUntil(3);
  EXPECT_EQ(clock.Now(), 9);
  clock.Advance(2);
  EXPECT_EQ(clock.Now(), 11);
}
} // namespace
} // namespace palpate::steady_clock_test
