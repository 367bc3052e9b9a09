#include "TaskCases.h"
#include "TaskPlan.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <utility>

namespace palpate::task_plan_test
{
namespace
{
using namespace palpate::test;

TEST(TaskOrder, EachConditionIsOnceInEachRowAndEquallyOftenInEachColumn)
{
  for (int count = 1; count <= 12; ++count)
  {
    const auto rows = WilliamsRows(count);
    ASSERT_EQ(rows.size(),
              static_cast<std::size_t>(count % 2 == 0 || count == 1 ? count : 2 * count));
    const int often = static_cast<int>(rows.size()) / count;
    std::map<std::pair<int, int>, int> places; // of a condition in a column
    for (const auto& row : rows)
    {
      EXPECT_EQ(std::set<int>(row.begin(), row.end()).size(), static_cast<std::size_t>(count));
      EXPECT_EQ(row.size(), static_cast<std::size_t>(count));
      for (int column = 0; column < count; ++column)
      {
        ++places[{row[static_cast<std::size_t>(column)], column}];
      }
    }
    for (int condition = 0; condition < count; ++condition)
    {
      for (int column = 0; column < count; ++column)
      {
        EXPECT_EQ((places[{condition, column}]), often) << count;
      }
    }
  }
}

TEST(TaskOrder, EachConditionFollowsEachOtherEquallyOften)
{
  for (int count = 2; count <= 12; ++count)
  {
    std::map<std::pair<int, int>, int> pairs;
    for (const auto& row : WilliamsRows(count))
    {
      for (std::size_t i = 1; i < row.size(); ++i)
      {
        ++pairs[{row[i - 1], row[i]}];
      }
    }
    EXPECT_EQ(pairs.size(), static_cast<std::size_t>(count * (count - 1)));
    for (const auto& [pair, times] : pairs)
    {
      EXPECT_EQ(times, count % 2 == 0 ? 1 : 2) << count << ": " << pair.first << pair.second;
    }
  }
}

TEST(TaskPlan, TrainsBeforeEachConditionAndPausesBetween)
{
  const TaskSettings task = TaskOf(TaskKind::Landmarks);
  for (int participant = 1; participant <= 4; ++participant)
  {
    const auto trials = PlanOf(task, participant);
    ASSERT_EQ(trials.size(), 6U);
    for (std::size_t i = 0; i < trials.size(); ++i)
    {
      EXPECT_EQ(trials[i].Number, static_cast<int>(i) + 1);
      EXPECT_EQ(trials[i].IsTraining, i % 3 == 0);
      EXPECT_EQ(task.Targets[trials[i].Target].IsTraining, trials[i].IsTraining);
      EXPECT_EQ(trials[i].Condition, (i / 3 + static_cast<std::size_t>(participant) + 1) % 2);
      EXPECT_EQ(trials[i].EndsBlock, i == 2); // not after the last
    }
  }
}

TEST(TaskPlan, NoTargetComesAgainBeforeAllHaveCome)
{
  TaskSettings task = TaskOf(TaskKind::Landmarks);
  task.Targets.pop_back();
  for (int extra = 0; extra < 5; ++extra)
  {
    task.Targets.push_back(task.Targets.front());
    task.Targets.back().Id = "more-" + std::to_string(extra);
  }
  task.Trials = 14;
  task.TrainingTrials = 0;
  std::set<std::vector<std::size_t>> orders;
  for (int participant = 1; participant <= 20; ++participant)
  {
    const auto trials = PlanOf(task, participant);
    std::vector<std::size_t> order;
    for (std::size_t start = 0; start < trials.size(); start += 7)
    {
      std::set<std::size_t> used;
      for (std::size_t i = start; i < start + 7; ++i)
      {
        used.insert(trials[i].Target);
        order.push_back(trials[i].Target);
      }
      EXPECT_EQ(used.size(), 7U);
    }
    orders.insert(order);
  }
  EXPECT_EQ(orders.size(), 20U); // random: two equal orders are unlikely
}

TEST(TaskPlan, DependsOnTheSeedAndTheParticipantOnly)
{
  TaskSettings task = TaskOf(TaskKind::Landmarks);
  task.Trials = 100;
  const auto targetsOf = [](const TaskSettings& one, int participant)
  {
    std::vector<std::size_t> targets;
    for (const TaskTrial& trial : PlanOf(one, participant))
    {
      targets.push_back(trial.Target);
    }
    return targets;
  };
  const auto first = targetsOf(task, 1);
  EXPECT_EQ(targetsOf(task, 1), first);
  EXPECT_NE(targetsOf(task, 3), first);
  task.Seed = 2;
  EXPECT_NE(targetsOf(task, 1), first);
}
} // namespace
} // namespace palpate::task_plan_test
