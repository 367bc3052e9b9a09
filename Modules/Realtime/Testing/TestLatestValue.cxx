#include "LatestValue.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <thread>

namespace palpate::latest_value_test
{
namespace
{
// Large enough that a torn copy would show.
struct Numbers
{
  std::array<std::uint64_t, 32> Values{};

  static Numbers All(std::uint64_t value)
  {
    Numbers numbers;
    numbers.Values.fill(value);
    return numbers;
  }
};

TEST(LatestValue, ReturnsInitialValueUntilPublish)
{
  LatestValue<int> value(7);
  EXPECT_EQ(value.Latest(), 7);
}

TEST(LatestValue, ReturnsNewestRepeatedly)
{
  LatestValue<int> value;
  for (int i = 1; i < 10; ++i)
  {
    value.Publish(i);
    value.Publish(10 * i);
    EXPECT_EQ(value.Latest(), 10 * i);
    EXPECT_EQ(value.Latest(), 10 * i);
  }
}

TEST(LatestValue, ReferenceStaysValidUntilNextRead)
{
  LatestValue<int> value;
  for (int i = 1; i < 10; ++i)
  {
    value.Publish(i);
    const int& latest = value.Latest();
    for (int later = 100; later < 105; ++later)
    {
      value.Publish(later);
      EXPECT_EQ(latest, i);
    }
  }
}

TEST(LatestValue, NeverTornAndNeverGoesBack)
{
  constexpr std::uint64_t last = 50'000;
  LatestValue<Numbers> value;
  std::thread writer(
      [&]
      {
        for (std::uint64_t i = 1; i <= last; ++i)
        {
          value.Publish(Numbers::All(i));
        }
      });
  std::uint64_t seen = 0;
  bool isWhole = true;
  bool isOrdered = true;
  while (seen < last)
  {
    const Numbers& numbers = value.Latest();
    for (const std::uint64_t n : numbers.Values)
    {
      isWhole = isWhole && n == numbers.Values[0];
    }
    isOrdered = isOrdered && numbers.Values[0] >= seen;
    seen = numbers.Values[0];
  }
  writer.join();
  EXPECT_TRUE(isWhole);
  EXPECT_TRUE(isOrdered);
}
} // namespace
} // namespace palpate::latest_value_test
