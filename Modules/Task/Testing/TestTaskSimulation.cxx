#include "HandTremor.h"
#include "InputError.h"
#include "MaskTruth.h"
#include "MessageOf.h"
#include "SceneFile.h"
#include "SimulatedParticipant.h"
#include "TaskCases.h"
#include "TaskResults.h"
#include "TaskSimulation.h"
#include "TouchRun.h"

#include <gtest/gtest.h>

namespace palpate::task_simulation_test
{
namespace
{
using namespace palpate::test;

const ProgressFunction GoOn = [](double, const std::string&) { return true; };

class TaskSimulationTest : public testing::Test
{
protected:
  TaskSettings BallTask(TaskKind kind) const
  {
    TaskSettings task = TaskOf(kind);
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = this->Scene;
    }
    task.Trials = 1;
    return task;
  }
  PreparedTouch Touch() const
  {
    TouchScript script;
    script.Path = HandPath({{0.0, Vector3::Zero()}});
    return PrepareTouch(ReadScene(this->Scene), script, GoOn);
  }
  // What an exact hand does, with force or without.
  TaskScore Exactly(TaskKind kind, bool hasForce) const
  {
    return this->Exactly(this->BallTask(kind), hasForce);
  }
  TaskScore Exactly(const TaskSettings& task, bool hasForce) const
  {
    const TaskKind kind = task.Kind;
    const PreparedTouch touch = this->Touch();
    TaskHand hand(touch, task, hasForce, HandSkill::Exact(), Vector3::UnitY(), 1);
    const TaskAnswer answer =
        SimulatedParticipant(hand, HandSkill::Exact(), 1, touch.Settings).Do(kind, task.Targets[0]);
    EXPECT_EQ(hand.Watched().Measured().PeakForce > 0.0, hasForce && kind != TaskKind::Path);
    return ScoreOf(kind, task.Targets[0], answer, hand.Watched().Measured());
  }
  std::string Simulate(const TaskSettings& task, std::uint64_t seed, const std::string& name) const
  {
    const std::filesystem::path folder = this->Folder / name;
    std::filesystem::create_directory(folder);
    SimulateTask(task, {2, "novice", seed}, folder, GoOn);
    return TaskResultsCsv(ReadTaskResults(folder));
  }

  TemporaryFolder Folder;
  std::filesystem::path Scene = WriteBall(this->Folder);
};

// Encoders count 0.045 mm, and friction of 0.02 N stops a hand of 0.5 N/mm within 0.04 mm.
constexpr double Hand = 0.1; // mm

TEST_F(TaskSimulationTest, ExactHandsMarkExactly)
{
  EXPECT_LT(this->Exactly(TaskKind::Landmarks, true).Values[1], Hand);
  EXPECT_LT(this->Exactly(TaskKind::Landmarks, false).Values[1], Hand);
}

TEST_F(TaskSimulationTest, ExactHandsFollowPathsWithoutContact)
{
  for (const bool hasForce : {true, false})
  {
    const TaskScore score = this->Exactly(TaskKind::Path, hasForce);
    EXPECT_EQ(score.Values[0], 0.0);
    EXPECT_LT(score.Values[2], Hand);
    EXPECT_EQ(score.Values[3], 1.0);
  }
}

TEST_F(TaskSimulationTest, OutlineWithForceIsTheTouchedSurface)
{
  EXPECT_LT(this->Exactly(TaskKind::Outline, true).Values[1], Hand);
  EXPECT_LT(this->Exactly(TaskKind::Outline, false).Values[1], Hand);
  // One that is shown too narrow by half a millimetre is corrected by what is felt.
  TaskSettings narrow = this->BallTask(TaskKind::Outline);
  for (TaskPoint& point : narrow.Targets[0].Points)
  {
    point.PointWorld *= 19.5 / BallRadius;
  }
  EXPECT_NEAR(this->Exactly(narrow, true).Values[1], 0.5, Hand);
  EXPECT_LT(this->Exactly(narrow, false).Values[1], Hand);
}

TEST_F(TaskSimulationTest, EqualSeedsGiveEqualLogs)
{
  const TaskSettings task = this->BallTask(TaskKind::Landmarks);
  const std::string first = this->Simulate(task, 1, "a");
  EXPECT_EQ(this->Simulate(task, 1, "b"), first);
  EXPECT_NE(this->Simulate(task, 2, "c"), first);
  for (const char* log : {"participant-0001.jsonl", "participant-0002.jsonl"})
  {
    EXPECT_EQ(ReadAll(this->Folder / "a" / log), ReadAll(this->Folder / "b" / log));
  }
}

TEST_F(TaskSimulationTest, AResumedSimulationGivesTheSameResults)
{
  const TaskSettings task = this->BallTask(TaskKind::Path);
  const std::string whole = this->Simulate(task, 1, "a");
  const std::filesystem::path log = this->Folder / "a" / "participant-0001.jsonl";
  const std::string text = ReadAll(log);
  WriteAll(log, text.substr(0, text.rfind("\"event\":\"start\"")) + "x");
  EXPECT_EQ(this->Simulate(task, 1, "a"), whole);
}

TEST_F(TaskSimulationTest, PatchesChangeTheSceneOfACondition)
{
  TaskSettings task = this->BallTask(TaskKind::Landmarks);
  WriteAll(this->Folder / "soft.json",
           R"([{"op": "replace", "path": "/structures/0/stiffness_n_per_mm", "value": 0.2}])");
  const std::string hard = this->Simulate(task, 1, "hard");
  task.Conditions[0].Patch = this->Folder / "soft.json";
  EXPECT_EQ(ReadScene(this->Scene, task.Conditions[0].Patch).Structures[0].Stiffness, 0.2);
  EXPECT_NE(this->Simulate(task, 1, "soft"), hard);
  WriteAll(this->Folder / "bad.json", R"([{"op": "replace", "path": "/nothing", "value": 1}])");
  for (const char* patch : {"bad.json", "absent.json", "ball.json"})
  {
    EXPECT_TRUE(Contains(MessageOf([&] { ReadScene(this->Scene, this->Folder / patch); }), patch));
  }
}

TEST_F(TaskSimulationTest, UnknownLevelsAreRefused)
{
  EXPECT_THROW(
      SimulateTask(this->BallTask(TaskKind::Path), {1, "master", 1}, this->Folder.Path(), GoOn),
      InputError);
}

// One trial of a kind that is done in a mode of the window, with this skill.
class ModeSimulation : public TaskSimulationTest
{
protected:
  TaskSettings MaskTask() const
  {
    TaskSettings task = TaskOf(TaskKind::Mask);
    const std::filesystem::path scene = WriteWrongMask(this->Folder);
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = scene;
      target.Mask = this->Folder / "true.nii.gz";
    }
    return task;
  }
  TaskSettings DockTask() const
  {
    TaskSettings task = TaskOf(TaskKind::Dock);
    const Vector3 way(6.0, -5.0, 3.0);
    const std::filesystem::path scene = WriteTwoBalls(this->Folder, way);
    for (TaskTarget& target : task.Targets)
    {
      target.Scene = scene;
      target.Points = {{"", Vector3::Zero()}};
      target.Pose = {way, Vector3(0.0, 0.0, 20.0)};
    }
    return task;
  }
  TaskScore Do(const TaskSettings& task, bool hasForce, const HandSkill& skill,
               std::uint64_t seed = 1) const
  {
    TouchScript script;
    script.Path = HandPath({{0.0, Vector3::Zero()}});
    const TaskTarget& target = task.Targets.front();
    const PreparedTouch touch = PrepareTouch(ReadScene(target.Scene), script, GoOn);
    TaskHand hand(touch, task, hasForce, skill, Vector3::UnitY(), seed);
    const TaskAnswer answer =
        SimulatedParticipant(hand, skill, seed, touch.Settings).Do(task.Kind, target);
    EXPECT_EQ(hand.Watched().Measured().PeakForce > 0.0, hasForce);
    EXPECT_EQ(hand.Watched().Measured().End, TaskEnd::Done);
    return ScoreOf(task.Kind, target, answer, hand.Watched().Measured());
  }
};

TEST_F(ModeSimulation, ExactHandsPullAMaskOntoTheOrgan)
{
  const TaskSettings task = this->MaskTask();
  const SceneSettings scene = ReadScene(task.Targets.front().Scene);
  CorrectedShape start = ReadWrongMask(task.Targets.front(), scene);
  const TaskAnswer before = MaskAnswer(start, ReadTrueMask(task.Targets.front(), scene));
  for (const bool hasForce : {true, false})
  {
    const TaskScore score = this->Do(task, hasForce, HandSkill::Exact());
    EXPECT_GT(score.Values[0], 0.97);
    // Places that seem to be less than 1 mm off are left.
    EXPECT_LT(score.Values[1], 0.4);
    EXPECT_LT(score.Values[1], 0.5 * before.MeanDistance);
  }
}

TEST_F(ModeSimulation, ErrorsOfTheEyeAndHandLeaveAMaskWorse)
{
  const TaskSettings task = this->MaskTask();
  HandSkill poor = HandSkill::Exact();
  poor.SeenErrorDeviation = 2.0;
  poor.PullDeviation = 3.0;
  EXPECT_GT(this->Do(task, true, poor).Values[1],
            this->Do(task, true, HandSkill::Exact()).Values[1] + 0.2);
}

TEST_F(ModeSimulation, ExactHandsDockExactly)
{
  for (const bool hasForce : {true, false})
  {
    const TaskScore score = this->Do(this->DockTask(), hasForce, HandSkill::Exact());
    EXPECT_LT(score.Values[0], Hand);
    EXPECT_LT(score.Values[1], 1e-6);
  }
}

// The fit of a ball, of a third of 0.5 N/mm in each direction, pulls the hand, of 0.5 N/mm, to
// where the body belongs: a fourth of what is seen wrong.
TEST_F(ModeSimulation, FeltFitCorrectsWhatIsSeenWrong)
{
  HandSkill skill = HandSkill::Exact();
  skill.AimDeviation = 1.5;
  double felt = 0.0;
  double seen = 0.0;
  for (std::uint64_t seed = 1; seed <= 3; ++seed)
  {
    felt += this->Do(this->DockTask(), true, skill, seed).Values[0];
    seen += this->Do(this->DockTask(), false, skill, seed).Values[0];
  }
  EXPECT_LT(felt, 0.9 * seen);
  EXPECT_GT(seen / 3.0, 0.5);
}

TEST_F(ModeSimulation, EqualSeedsGiveEqualResultsOfBothKinds)
{
  for (TaskSettings task : {this->MaskTask(), this->DockTask()})
  {
    task.Trials = 1;
    task.TrainingTrials = 0;
    task.Conditions.resize(1);
    std::vector<std::string> tables;
    for (const char* name : {"a", "b"})
    {
      const std::filesystem::path folder = this->Folder / (NameOf(task.Kind) + name);
      std::filesystem::create_directory(folder);
      SimulateTask(task, {1, "expert", 1}, folder, GoOn);
      tables.push_back(TaskResultsCsv(ReadTaskResults(folder)));
    }
    EXPECT_EQ(tables[0], tables[1]);
  }
}

TEST_F(TaskSimulationTest, TimeLimitEndsATrial)
{
  TaskSettings task = this->BallTask(TaskKind::Landmarks);
  task.MostSeconds = 1.0;
  const PreparedTouch touch = this->Touch();
  TaskHand hand(touch, task, true, HandSkill::Novice(), Vector3::UnitY(), 1);
  const TaskAnswer answer = SimulatedParticipant(hand, HandSkill::Novice(), 1, touch.Settings)
                                .Do(task.Kind, task.Targets[0]);
  EXPECT_EQ(hand.Watched().Measured().End, TaskEnd::Time);
  EXPECT_NEAR(hand.Watched().Measured().Seconds, 1.0, 1e-6);
  EXPECT_TRUE(std::isnan(answer.PointsWorld.back().x()));
}

// The device adds nothing: a free hand trembles as much as was published.
TEST_F(TaskSimulationTest, FreeHandsTrembleAsMuchAsWasPublished)
{
  TaskSettings task = this->BallTask(TaskKind::Path);
  HandSkill skill;
  skill.Tremor = HandSkill::Novice().Tremor;
  const PreparedTouch touch = this->Touch();
  TaskHand hand(touch, task, true, skill, Vector3::UnitY(), 1);
  Vector3 squares = Vector3::Zero();
  const Vector3 rest =
      touch.Frame.ToWorld(touch.Frame.ToDevice(hand.Center() + hand.Outside() * Vector3::UnitY()));
  constexpr int Ticks = 20000;
  for (int i = 0; i < Ticks; ++i)
  {
    hand.Hold(0.001);
    squares += (hand.TipWorld() - rest).cwiseAbs2() / Ticks;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    // 20 s at 3 Hz are some 60 independent values; the hand passes 9 Hz by 0.97.
    EXPECT_NEAR(std::sqrt(squares[axis]), skill.Tremor[axis], 0.2 * skill.Tremor[axis]);
  }
}

TEST(HandTremor, HasUnitSizeBetween6And12Hz)
{
  std::mt19937_64 random(1);
  HandTremor tremor(1000.0);
  double squares = 0.0;
  int crossings = 0; // of zero, upwards
  double last = 0.0;
  constexpr int Ticks = 400000;
  for (int i = 0; i < Ticks; ++i)
  {
    const double x = tremor.Next(random).x();
    squares += x * x / Ticks;
    crossings += last < 0.0 && x >= 0.0 ? 1 : 0;
    last = x;
  }
  EXPECT_NEAR(std::sqrt(squares), 1.0, 0.05); // some 1200 independent values
  EXPECT_GT(crossings / 400.0, 6.0);
  EXPECT_LT(crossings / 400.0, 12.0);
}
} // namespace
} // namespace palpate::task_simulation_test
