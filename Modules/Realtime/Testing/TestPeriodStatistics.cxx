#include "PeriodStatistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>
#include <vector>

namespace palpate::period_statistics_test
{
namespace
{
std::vector<std::int64_t> RandomDurations(std::size_t count, std::uint64_t seed)
{
  std::mt19937_64 random(seed);
  std::lognormal_distribution<double> duration(10.0, 3.0);
  std::vector<std::int64_t> durations(count);
  std::generate(durations.begin(), durations.end(),
                [&] { return static_cast<std::int64_t>(duration(random)); });
  return durations;
}

PeriodStatistics StatisticsOf(const std::vector<std::int64_t>& durations)
{
  PeriodStatistics statistics;
  std::for_each(durations.begin(), durations.end(), [&](std::int64_t d) { statistics.Add(d); });
  return statistics;
}

TEST(PeriodStatistics, QuantilesAreAtMostASixteenthTooLarge)
{
  std::vector<std::int64_t> durations = RandomDurations(10'000, 3);
  const PeriodStatistics statistics = StatisticsOf(durations);
  std::sort(durations.begin(), durations.end());
  for (const double fraction : {0.0, 0.001, 0.25, 0.5, 0.9, 0.999, 1.0})
  {
    const auto rank = static_cast<std::size_t>(std::max(1.0, std::ceil(fraction * 10'000.0)));
    const std::int64_t exact = durations[rank - 1];
    EXPECT_GE(statistics.Quantile(fraction), exact) << fraction;
    EXPECT_LE(statistics.Quantile(fraction), exact + exact / 16) << fraction;
  }
}

TEST(PeriodStatistics, CountExtremesAndMeanAreExact)
{
  const std::vector<std::int64_t> durations = RandomDurations(1000, 4);
  const PeriodStatistics statistics = StatisticsOf(durations);
  EXPECT_EQ(statistics.Count(), 1000u);
  EXPECT_EQ(statistics.Min(), *std::min_element(durations.begin(), durations.end()));
  EXPECT_EQ(statistics.Max(), *std::max_element(durations.begin(), durations.end()));
  // The same additions in the same order.
  EXPECT_EQ(statistics.Mean(), std::accumulate(durations.begin(), durations.end(), 0.0) / 1000.0);
}

TEST(PeriodStatistics, MissesAddUp)
{
  PeriodStatistics statistics;
  statistics.AddMisses(2);
  statistics.AddMisses(3);
  EXPECT_EQ(statistics.Misses(), 5u);
}

TEST(PeriodStatistics, CountsExtremeDurations)
{
  PeriodStatistics statistics = StatisticsOf({-5, 0, 15, 16, 17, INT64_MAX});
  EXPECT_EQ(statistics.Min(), 0);
  EXPECT_EQ(statistics.Quantile(0.5), 15);
  EXPECT_EQ(statistics.Quantile(1.0), INT64_MAX);
}

TEST(PeriodStatistics, QuantilesLieWithinExtremes)
{
  // 100 to 103 ns share a class.
  const PeriodStatistics one = StatisticsOf({101});
  EXPECT_EQ(one.Median(), 101);
  EXPECT_EQ(StatisticsOf({101, 102}).Quantile(1.0), 102);
}

TEST(PeriodStatistics, EmptyReturnsZero)
{
  const PeriodStatistics statistics;
  EXPECT_EQ(statistics.Min(), 0);
  EXPECT_EQ(statistics.Max(), 0);
  EXPECT_EQ(statistics.Mean(), 0.0);
  EXPECT_EQ(statistics.Median(), 0);
}
} // namespace
} // namespace palpate::period_statistics_test
