#include "LoopSchedule.h"

#include <gtest/gtest.h>

#include <random>

namespace palpate::loop_schedule_test
{
namespace
{
TEST(LoopSchedule, TicksOrSkipsEveryDeadlineOnce)
{
  std::mt19937_64 random(7);
  constexpr std::int64_t period = 1000;
  constexpr std::int64_t start = 12'345;
  LoopSchedule schedule(start, period);
  std::exponential_distribution<double> duration(1.0 / 700.0);
  std::int64_t now = start;
  std::int64_t deadlines = 0;
  for (std::uint64_t n = 0; n < 100'000; ++n)
  {
    now = std::max(now, schedule.Deadline());
    const TickInfo tick = schedule.Begin(now);
    deadlines += 1 + static_cast<std::int64_t>(tick.SkippedPeriods);
    ASSERT_EQ(tick.Number, n);
    ASSERT_EQ(tick.Scheduled, start + (deadlines - 1) * period);
    ASSERT_GE(tick.Started, tick.Scheduled);
    ASSERT_LT(tick.Started - tick.Scheduled, period);
    now += static_cast<std::int64_t>(duration(random));
  }
}

TEST(LoopSchedule, LateBeyondATenthOfAPeriod)
{
  LoopSchedule schedule(0, 1000);
  EXPECT_FALSE(schedule.Begin(100).IsLate);
  EXPECT_TRUE(schedule.Begin(1101).IsLate);
  EXPECT_FALSE(schedule.Begin(2000).IsLate);
}

TEST(LoopSchedule, SmallOverrunIsFollowedAtOnce)
{
  LoopSchedule schedule(0, 1000);
  static_cast<void>(schedule.Begin(0));
  const TickInfo tick = schedule.Begin(1999);
  EXPECT_EQ(tick.SkippedPeriods, 0u);
  EXPECT_EQ(tick.Scheduled, 1000);
  EXPECT_EQ(schedule.Deadline(), 2000);
}
} // namespace
} // namespace palpate::loop_schedule_test
