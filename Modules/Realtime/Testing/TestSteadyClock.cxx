#include "ManualClock.h"
#include "SteadyClock.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
TEST(SteadyClock, WaitsEndAtTheirTimeOrLater)
{
  // Asleep, partly, and spinning all the time.
  for (const std::int64_t spin :
       {std::int64_t{0}, std::int64_t{50'000}, std::int64_t{1'000'000'000}})
  {
    SteadyClock clock(spin);
    for (int i = 0; i < 20; ++i)
    {
      const std::int64_t until = clock.Now() + 100'000;
      clock.WaitUntil(until);
      EXPECT_GE(clock.Now(), until);
    }
  }
}

TEST(SteadyClock, DoesNotWaitForThePast)
{
  SteadyClock clock(1'000);
  clock.WaitUntil(INT64_MIN / 2);
  clock.WaitUntil(clock.Now() - 1);
}

TEST(ManualClock, MovesOnlyAsToldAndNeverBack)
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
} // namespace palpate
