#include "PathCourse.h"
#include "TaskCases.h"
#include "TaskScore.h"
#include "TaskWatch.h"

#include <gtest/gtest.h>

namespace palpate::task_score_test
{
namespace
{
using namespace palpate::test;

constexpr double Rounding = 1e-9; // mm

TaskScore Score(TaskKind kind, const TaskTarget& target, const TaskAnswer& answer,
                const TaskConduct& conduct = {})
{
  TaskScore score = ScoreOf(kind, target, answer, conduct);
  EXPECT_EQ(score.Values.size(), TaskMeasures(kind).size());
  return score;
}

void ExpectValues(const TaskScore& score, const std::vector<double>& values)
{
  ASSERT_EQ(score.Values.size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    EXPECT_NEAR(score.Values[i], values[i], Rounding) << i;
  }
}

TEST(TaskScore, RightAnswersAreWithoutError)
{
  const std::vector<std::vector<double>> wanted{{1, 0, 0}, {0, 0, 0}, {1, 0},
                                                {1, 0},    {0, 0},    {0, 0, 0, 1}};
  for (std::size_t i = 0; i < wanted.size(); ++i)
  {
    const auto kind = static_cast<TaskKind>(i);
    const TargetCase made = TargetOf(kind);
    const TaskScore score = Score(kind, made.Target, made.Right);
    ExpectValues(score, wanted[i]);
    EXPECT_TRUE(score.IsSuccess) << NameOf(kind);
    TaskConduct late;
    late.End = TaskEnd::Time;
    EXPECT_FALSE(Score(kind, made.Target, made.Right, late).IsSuccess) << NameOf(kind);
  }
}

TEST(TaskScore, NoduleIsFoundBesideTheSideThatIsPalpated)
{
  TargetCase made = TargetOf(TaskKind::Nodule);
  made.Right.Diameter = 11.0;
  made.Right.PointsWorld[0] += Vector3(0.6, -3.0, 0.8); // 3 mm of it pressed in
  TaskScore score = Score(TaskKind::Nodule, made.Target, made.Right);
  ExpectValues(score, {1, 1, 3});
  EXPECT_TRUE(score.IsSuccess);
  made.Right.PointsWorld[0].x() += 2.0;
  EXPECT_FALSE(Score(TaskKind::Nodule, made.Target, made.Right).IsSuccess);
  EXPECT_FALSE(Score(TaskKind::Nodule, made.Target, {}).IsSuccess);
  made.Target.Points.clear();
  EXPECT_TRUE(Score(TaskKind::Nodule, made.Target, {}).IsSuccess);
  EXPECT_FALSE(Score(TaskKind::Nodule, made.Target, made.Right).IsSuccess);
}

TEST(TaskScore, LandmarksThatWereLeftOutAreCounted)
{
  TargetCase made = TargetOf(TaskKind::Landmarks);
  made.Right.PointsWorld[0] += Vector3(0, 0.3, 0.4);
  made.Right.PointsWorld[1] += Vector3(1.0, 0, 0);
  ExpectValues(Score(TaskKind::Landmarks, made.Target, made.Right), {0.75, 1, 0});
  made.Right.PointsWorld[1] = Vector3::Constant(std::nan(""));
  const TaskScore score = Score(TaskKind::Landmarks, made.Target, made.Right);
  ExpectValues(score, {0.5, 0.5, 1});
  EXPECT_FALSE(score.IsSuccess);
  EXPECT_TRUE(std::isnan(Score(TaskKind::Landmarks, made.Target, {}).Values[0]));
}

TEST(TaskScore, OutlinesOfSquaresHaveTheirExactOverlap)
{
  TaskTarget target;
  TaskAnswer answer;
  for (const auto& [x, y] : {std::pair(0, 0), {10, 0}, {10, 10}, {0, 10}})
  {
    target.Points.push_back({"", Vector3(x, 2.0, y)});
    answer.PointsWorld.emplace_back(x + 5.0, 2.7, y); // projected onto the plane
  }
  // Half of each is shared.
  const TaskScore score = Score(TaskKind::Outline, target, answer);
  // Lines sample the area at 2000 places.
  EXPECT_NEAR(score.Values[0], 0.5, 1e-3);
  // One side is 5 mm off, the opposite one 2.5 mm on average, and so is half of each other one.
  EXPECT_NEAR(score.Values[1], (10 * 5.0 + 10 * 2.5 + 2 * 5 * 2.5) / 40, Rounding);
}

TEST(TaskScore, OutlineDoesNotDependOnWhereAndHowItIsDrawn)
{
  TargetCase made = TargetOf(TaskKind::Outline);
  std::rotate(made.Right.PointsWorld.begin(), made.Right.PointsWorld.begin() + 7,
              made.Right.PointsWorld.end());
  std::reverse(made.Right.PointsWorld.begin(), made.Right.PointsWorld.end());
  ExpectValues(Score(TaskKind::Outline, made.Target, made.Right), {1, 0});
}

TEST(TaskScore, DockingErrorsAreThoseOfTheBodysPose)
{
  TargetCase made = TargetOf(TaskKind::Dock);
  made.Right.Shift += Vector3(0.3, 0.4, 0.0);
  made.Right.Turn = Vector3(0.0, 0.0, 27.0);
  ExpectValues(Score(TaskKind::Dock, made.Target, made.Right), {0.5, 3.0});
  made.Right.Turn = Vector3(0.0, 0.0, -180.0);
  EXPECT_NEAR(Score(TaskKind::Dock, made.Target, made.Right).Values[1], 150.0, 1e-6);
}

TEST(TaskScore, PathHasToBePassedInOrderToItsEnd)
{
  TargetCase made = TargetOf(TaskKind::Path);
  TaskConduct conduct;
  conduct.Contacts = 2;
  conduct.TouchedSeconds = 0.25;
  made.Right.PointsWorld.clear();
  for (const TaskPoint& point : made.Target.Points)
  {
    made.Right.PointsWorld.emplace_back(point.PointWorld + Vector3(0, 0, 0.5));
  }
  TaskScore score = Score(TaskKind::Path, made.Target, made.Right, conduct);
  ExpectValues(score, {2, 0.25, 0.5, 1});
  EXPECT_FALSE(score.IsSuccess);
  EXPECT_TRUE(Score(TaskKind::Path, made.Target, made.Right).IsSuccess);
  made.Right.PointsWorld.resize(18);
  score = Score(TaskKind::Path, made.Target, made.Right);
  EXPECT_NEAR(score.Values[3], 0.55, 0.05);
  std::reverse(made.Right.PointsWorld.begin(), made.Right.PointsWorld.end());
  EXPECT_LT(Score(TaskKind::Path, made.Target, made.Right).Values[3], 0.1);
}

TouchState Tick(double seconds, double force, double depth)
{
  TouchState tick;
  tick.HasSample = true;
  tick.Tick.Started = std::llround(1e9 * seconds);
  tick.ForceWorld = Vector3(0, 0, force);
  tick.Structure = depth > 0.0 ? 0 : -1;
  tick.Depth = depth;
  tick.ProbeWorld = Vector3(10.0 * seconds, 0, -depth);
  tick.ProxyWorld = Vector3(10.0 * seconds, 0, 0);
  return tick;
}

TEST(TaskWatch, MeasuresContactsForcesAndTheToolsWay)
{
  TaskWatch watch(TaskOf(TaskKind::Path), true, 1.0);
  watch.Take(Tick(5.0, 0, 0));
  watch.Take(Tick(5.5, 1, 0.5));
  watch.Take(Tick(6.0, 3, 1.0));
  watch.Take(Tick(6.5, 0, 0));
  watch.Take(Tick(7.0, 2, 0.2));
  const TaskConduct& conduct = watch.Measured();
  EXPECT_DOUBLE_EQ(conduct.Seconds, 2.0);
  EXPECT_EQ(conduct.Contacts, 2);
  EXPECT_DOUBLE_EQ(conduct.TouchedSeconds, 1.5);
  EXPECT_DOUBLE_EQ(conduct.MeanForce, 2.0);
  EXPECT_DOUBLE_EQ(conduct.PeakForce, 3.0);
  EXPECT_DOUBLE_EQ(conduct.DeepestMillimeters, 1.0);
  EXPECT_DOUBLE_EQ(conduct.PathMillimeters, 20.0);
}

TEST(TaskWatch, ToolIsAtTheHandWithoutForce)
{
  const TouchState tick = Tick(1.0, 1.0, 0.5);
  EXPECT_EQ(TaskWatch(TaskOf(TaskKind::Path), true, 1.0).TipWorld(tick), Vector3(10, 0, -1));
  EXPECT_EQ(TaskWatch(TaskOf(TaskKind::Path), false, 1.0).TipWorld(tick), Vector3(10, 0, -0.5));
}

TEST(PathCourse, PassesPlacesOneAfterAnother)
{
  TaskTarget target = TargetOf(TaskKind::Path).Target;
  target.Points = {{"", {0, 0, 0}}, {"", {100, 0, 0}}};
  target.Tolerance = 2.0;
  PathCourse course(target);
  course.Take({50, 0, 0});
  EXPECT_EQ(course.Share(), 0.0) << "not from its start";
  for (double x = 0.0; x <= 50.0; x += 1.0)
  {
    course.Take({x, 1.0, 0.0});
  }
  const double half = course.Share();
  EXPECT_NEAR(half, 0.5, 0.03);
  course.Take({90, 0, 0});
  EXPECT_EQ(course.Share(), half) << "a part was left out";
  for (double x = 50.0; x <= 100.0; x += 1.0)
  {
    course.Take({x, 0, 0});
  }
  EXPECT_EQ(course.Share(), 1.0);
}

TEST(TaskWatch, LimitsEndATrial)
{
  TaskSettings task = TaskOf(TaskKind::Path);
  task.MostSeconds = 1.0;
  task.MostForce = 2.0;
  TaskWatch slow(task, true, 1.0);
  slow.Take(Tick(0.0, 0, 0));
  slow.Take(Tick(0.99, 2.0, 1));
  EXPECT_FALSE(slow.IsOver());
  slow.Take(Tick(1.0, 0, 0));
  EXPECT_TRUE(slow.IsOver());
  EXPECT_EQ(slow.Measured().End, TaskEnd::Time);
  slow.Take(Tick(2.0, 9, 1)); // no longer measured
  EXPECT_EQ(slow.Measured().PeakForce, 2.0);
  TaskWatch hard(task, true, 1.0);
  hard.Take(Tick(0.0, 2.01, 1));
  EXPECT_EQ(hard.Measured().End, TaskEnd::Force);
}
} // namespace
} // namespace palpate::task_score_test
