#include "TickBudget.h"

#include <gtest/gtest.h>

#include <vector>

namespace palpate
{
namespace
{
constexpr std::int64_t Period = 1'000'000; // ns
constexpr std::int64_t Second = 1'000'000'000;

// Ticks at 1 kHz, or as late as they are long, in a scene of two stand-ins.
class BudgetRun
{
public:
  // Ticks that each take a part of the period.
  int Ticks(int count, double part, int most = 2)
  {
    for (int n = 0; n < count; ++n)
    {
      const auto spent = static_cast<std::int64_t>(part * Period);
      this->Budget.Take(this->Now, spent, most);
      this->Now += std::max(Period, spent);
    }
    return this->Budget.Level();
  }
  // Quiet seconds until the level falls; -1 where it does not.
  double SecondsUntil(int level, double part = 0.1)
  {
    const std::int64_t start = this->Now;
    while (this->Budget.Level() != level)
    {
      this->Ticks(1, part);
      if (this->Now - start > 200 * Second)
      {
        return -1.0;
      }
    }
    return 1e-9 * static_cast<double>(this->Now - start);
  }

private:
  TickBudget Budget{Period};
  std::int64_t Now = 0;
};

TEST(TickBudget, TicksThatFitKeepTheModelsThemselves)
{
  BudgetRun run;
  EXPECT_EQ(run.Ticks(100'000, 0.69), 0);
}

TEST(TickBudget, TwoLongTicksSoonAfterEachOtherRaiseTheLevelAtOnce)
{
  BudgetRun run;
  EXPECT_EQ(run.Ticks(1, 0.8), 0);
  EXPECT_EQ(run.Ticks(48, 0.1), 0);
  EXPECT_EQ(run.Ticks(1, 0.8), 1);
  EXPECT_EQ(run.Ticks(2, 0.8), 2);
}

TEST(TickBudget, OneLongTickNowAndThenIsTheSystems)
{
  BudgetRun run;
  for (int n = 0; n < 100; ++n)
  {
    EXPECT_EQ(run.Ticks(1, 0.9), 0);
    EXPECT_EQ(run.Ticks(60, 0.1), 0);
  }
  for (int n = 0; n < 20; ++n)
  {
    EXPECT_EQ(run.Ticks(1, 5.0), 0);
    EXPECT_EQ(run.Ticks(1100, 0.1), 0);
  }
}

TEST(TickBudget, TwoTicksBeyondThePeriodWithinASecondRaiseTheLevel)
{
  BudgetRun run;
  EXPECT_EQ(run.Ticks(1, 1.1), 0);
  EXPECT_EQ(run.Ticks(900, 0.1), 0);
  EXPECT_EQ(run.Ticks(1, 1.1), 1);
}

TEST(TickBudget, TheLevelFallsAfterTwoSecondsOfRoomOneAtATime)
{
  BudgetRun run;
  ASSERT_EQ(run.Ticks(4, 3.0), 2);
  EXPECT_NEAR(run.SecondsUntil(1), 2.0, 0.01);
  EXPECT_NEAR(run.SecondsUntil(0), 2.0, 0.01);
}

TEST(TickBudget, WithoutRoomItDoesNotFall)
{
  BudgetRun run;
  ASSERT_EQ(run.Ticks(2, 3.0), 1);
  EXPECT_EQ(run.SecondsUntil(0, 0.5), -1.0);
}

TEST(TickBudget, WhereEachTryFailsItWaitsTwiceAsLongUpToAMinute)
{
  BudgetRun run;
  ASSERT_EQ(run.Ticks(2, 3.0), 1);
  std::vector<double> waits;
  for (int n = 0; n < 8; ++n)
  {
    waits.push_back(run.SecondsUntil(0));
    ASSERT_EQ(run.Ticks(2, 3.0), 1);
  }
  const double expected[] = {2.0, 4.0, 8.0, 16.0, 32.0, 64.0, 64.0, 64.0};
  for (int n = 0; n < 8; ++n)
  {
    EXPECT_NEAR(waits[static_cast<std::size_t>(n)], expected[n], 0.02);
  }
  // What holds for longer than it had waited is forgotten.
  EXPECT_NEAR(run.SecondsUntil(0), 64.0, 0.02);
  EXPECT_EQ(run.Ticks(65'000, 0.1), 0);
  ASSERT_EQ(run.Ticks(2, 3.0), 1);
  EXPECT_NEAR(run.SecondsUntil(0), 2.0, 0.01);
}

TEST(TickBudget, ItNeverAsksForMoreThanThereIs)
{
  BudgetRun run;
  EXPECT_EQ(run.Ticks(100, 3.0, 0), 0);
  EXPECT_EQ(run.Ticks(100, 3.0, 2), 2);
  EXPECT_EQ(run.Ticks(1, 0.1, 1), 1);
}
} // namespace
} // namespace palpate
