#include "TaskPower.h"

#include <cmath>
#include <gtest/gtest.h>
#include <random>

namespace palpate::task_power_test
{
namespace
{
// Participants whose mean error is `effect` larger in the second condition, with a scatter of 1.
TaskResults ResultsOf(int participants, double effect, std::uint64_t seed)
{
  TaskResults results;
  results.Conditions = {"a", "b"};
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < participants; ++i)
  {
    results.Participants.push_back({});
    for (const char* condition : {"a", "b"})
    {
      TaskResult row;
      row.Participant = static_cast<std::size_t>(i);
      row.End.Condition = condition;
      const bool isSecond = row.End.Condition == "b";
      row.End.Score.Values = {5.0 + (isSecond ? effect + normal(random) : 0.0), 0.0, 0.0};
      results.Rows.push_back(row);
    }
  }
  return results;
}

TEST(TaskPower, IntervalIsThatOfClopperAndPearson)
{
  // Their table, and R's binom.test.
  StudyPower power = BinomialInterval(12, 10, 5);
  EXPECT_NEAR(power.Low, 0.1870860, 1e-6);
  EXPECT_NEAR(power.High, 0.8129140, 1e-6);
  power = BinomialInterval(12, 10, 0);
  EXPECT_EQ(power.Low, 0.0);
  EXPECT_NEAR(power.High, 0.3084971, 1e-6);
  power = BinomialInterval(12, 10, 10);
  EXPECT_NEAR(power.Low, 0.6915029, 1e-6);
  EXPECT_EQ(power.High, 1.0);
}

// 2000 participants are as good as the normal distribution: the power of a paired t-test of n = 12
// at an effect of 1 standard deviation is 0.883 (noncentral t; R's power.t.test).
TEST(TaskPower, IsThatOfTheTTest)
{
  const TaskComparison comparison = CompareConditions(ResultsOf(2000, 1.0, 1), 4000, 1);
  EXPECT_NEAR(comparison.Difference, 1.0, 0.07); // three standard errors
  EXPECT_NEAR(comparison.DifferenceDeviation, 1.0, 0.05);
  for (const StudyPower& power : comparison.Powers)
  {
    const double share = static_cast<double>(power.Found) / power.Studies;
    EXPECT_LE(power.Low, share);
    EXPECT_GE(power.High, share);
    if (power.Participants == 12)
    {
      EXPECT_NEAR(share, 0.883, 0.04); // of the drawn effect's error, and 4000 studies'
    }
  }
  EXPECT_EQ(comparison.Sufficient, 12);
}

TEST(TaskPower, WithoutAnEffectIsTheSignificance)
{
  TaskResults results = ResultsOf(2000, 0.0, 2);
  // Exactly none: each difference comes with both signs.
  for (std::size_t i = 0; i + 3 < results.Rows.size(); i += 4)
  {
    results.Rows[i + 3].End.Score.Values[0] = 10.0 - results.Rows[i + 1].End.Score.Values[0];
  }
  const TaskComparison comparison = CompareConditions(results, 4000, 3);
  for (const StudyPower& power : comparison.Powers)
  {
    // Four standard errors of 4000 draws.
    EXPECT_NEAR(static_cast<double>(power.Found) / power.Studies, 0.05, 0.014)
        << power.Participants;
  }
  EXPECT_EQ(comparison.Sufficient, 0);
}

TEST(TaskPower, DependsOnTheSeedOnly)
{
  const TaskResults results = ResultsOf(20, 0.5, 3);
  const auto foundOf = [&](std::uint64_t seed)
  {
    std::vector<int> found;
    for (const StudyPower& power : CompareConditions(results, 500, seed).Powers)
    {
      found.push_back(power.Found);
    }
    return found;
  };
  EXPECT_EQ(foundOf(1), foundOf(1));
  EXPECT_NE(foundOf(1), foundOf(2));
}

TEST(TaskPower, NeedsTwoConditionsAndTwoParticipants)
{
  EXPECT_TRUE(CompareConditions(ResultsOf(1, 1.0, 1), 100, 1).Powers.empty());
  TaskResults results = ResultsOf(5, 1.0, 1);
  results.Conditions = {"a"};
  EXPECT_EQ(CompareConditions(results, 100, 1).Participants, 0);
  results = ResultsOf(5, 1.0, 1);
  for (TaskResult& row : results.Rows)
  {
    row.End.IsTraining = true;
  }
  EXPECT_EQ(CompareConditions(results, 100, 1).Participants, 0);
}

TEST(TaskPower, EqualDifferencesAreCertain)
{
  TaskResults results = ResultsOf(6, 0.0, 1);
  for (TaskResult& row : results.Rows)
  {
    row.End.Score.Values[0] = row.End.Condition == "b" ? 2.0 : 1.0;
  }
  EXPECT_EQ(CompareConditions(results, 100, 1).PValue, 0.0);
  for (TaskResult& row : results.Rows)
  {
    row.End.Score.Values[0] = 1.0;
  }
  EXPECT_EQ(CompareConditions(results, 100, 1).PValue, 1.0);
}
} // namespace
} // namespace palpate::task_power_test
