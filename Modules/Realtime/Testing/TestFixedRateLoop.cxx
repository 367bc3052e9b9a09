#include "FixedRateLoop.h"
#include "ManualClock.h"

#include <gtest/gtest.h>

#include <thread>
#include <vector>

namespace palpate::fixed_rate_loop_test
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns

TEST(FixedRateLoop, TicksStayOnePeriodApart)
{
  ManualClock clock(77);
  FixedRateLoop loop(clock, Period);
  std::vector<std::int64_t> starts;
  loop.Run(
      [&](const TickInfo& tick)
      {
        starts.push_back(tick.Started);
        clock.Advance(static_cast<std::int64_t>(starts.size()) * 200'000);
        return starts.size() < 5;
      });
  const std::vector<std::int64_t> expected{77, 77 + Period, 77 + 2 * Period, 77 + 3 * Period,
                                           77 + 4 * Period};
  EXPECT_EQ(starts, expected);
}

TEST(FixedRateLoop, SkipsMissedPeriodsAndKeepsGrid)
{
  ManualClock clock;
  FixedRateLoop loop(clock, Period);
  std::vector<TickInfo> ticks;
  loop.Run(
      [&](const TickInfo& tick)
      {
        ticks.push_back(tick);
        clock.Advance(ticks.size() == 2 ? 37 * Period / 10 : Period / 2);
        return ticks.size() < 4;
      });
  // The second tick starts at 1 and ends at 4.7 periods: 2 and 3 are skipped, 4 runs late.
  EXPECT_EQ(ticks[2].SkippedPeriods, 2u);
  EXPECT_EQ(ticks[2].Scheduled, 4 * Period);
  EXPECT_TRUE(ticks[2].IsLate);
  EXPECT_EQ(ticks[3].Scheduled, 5 * Period);
  EXPECT_EQ(ticks[3].SkippedPeriods, 0u);
}

TEST(FixedRateLoop, TicksReportBootTime)
{
  ManualClock clock;
  FixedRateLoop loop(clock, Period);
  std::vector<TickInfo> ticks;
  loop.Run(
      [&](const TickInfo& tick)
      {
        ticks.push_back(tick);
        clock.Suspend(7 * Period);
        return ticks.size() < 2;
      });
  EXPECT_EQ(ticks[0].BootTime, 0);
  EXPECT_EQ(ticks[1].Started, Period);
  EXPECT_EQ(ticks[1].BootTime, 8 * Period);
  EXPECT_EQ(ticks[1].SkippedPeriods, 0u);
}

TEST(FixedRateLoop, StopBeforeRunPreventsTicks)
{
  ManualClock clock;
  FixedRateLoop loop(clock, Period);
  loop.Stop();
  loop.Run(
      [](const TickInfo&)
      {
        ADD_FAILURE();
        return false;
      });
}

TEST(FixedRateLoop, StopDuringWaitPreventsTheNextTick)
{
  // Calls Stop during a wait.
  class StoppingClock final : public Clock
  {
  public:
    std::int64_t Now() const noexcept override { return this->Time; }
    void WaitUntil(std::int64_t time) noexcept override
    {
      this->Time = time;
      if (time >= 3 * Period)
      {
        this->Loop->Stop();
      }
    }
    FixedRateLoop* Loop = nullptr;

  private:
    std::int64_t Time = 0;
  };
  StoppingClock clock;
  FixedRateLoop loop(clock, Period);
  clock.Loop = &loop;
  int ticks = 0;
  loop.Run([&ticks](const TickInfo&) { return ++ticks < 10; });
  EXPECT_EQ(ticks, 3); // at 0, 1 and 2 periods
}

TEST(FixedRateLoop, StopsFromAnotherThread)
{
  ManualClock clock;
  FixedRateLoop loop(clock, Period);
  std::atomic<std::uint64_t> ticks{0};
  std::thread thread(
      [&]
      {
        loop.Run(
            [&](const TickInfo& tick)
            {
              ticks = tick.Number + 1;
              return true;
            });
      });
  while (ticks < 1000)
  {
    std::this_thread::yield();
  }
  loop.Stop();
  thread.join();
  EXPECT_GE(clock.Now(), 999 * Period);
}
} // namespace
} // namespace palpate::fixed_rate_loop_test
