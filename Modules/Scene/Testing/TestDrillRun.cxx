#include "DrillBlock.h"
#include "InputError.h"
#include "ProofCount.h"
#include "RemovalBytes.h"
#include "ResidentMemory.h"
#include "TouchReport.h"

#include <nlohmann/json.hpp>

namespace palpate::drill_run_test
{
namespace
{
using test::DrillBlock;

TouchResult Drilled(const PreparedTouch& touch, const std::filesystem::path& recording = {})
{
  TouchRunSettings settings;
  settings.Recording = recording;
  return RunTouch(touch, settings, test::NeverCancels);
}

std::vector<std::byte> StateOf(const PreparedTouch& touch)
{
  return BytesOf(*touch.Drill->Editor().Removed()[0]);
}

std::string Refusal(const SceneSettings& settings)
{
  try
  {
    test::Prepare(settings, DrillBlock::CanalAt(4.0));
  }
  catch (const InputError& error)
  {
    return error.what();
  }
  return {};
}

// The hand's spring (0.5 N/mm) pulls it down to its target height once the material between is
// removed; friction of the mechanism (0.2 N) may hold it 0.4 mm above, and moving at 2 mm/s leaves
// some material.
TEST(DrillRun, ScriptedHandDrillsACanalOfTheToolsSize)
{
  const DrillBlock block;
  constexpr double Height = 4.6; // 1 mm deep
  const PreparedTouch touch = test::Prepare(block.Settings(), DrillBlock::CanalAt(Height));
  const TouchResult result = Drilled(touch);
  EXPECT_EQ(result.Fault, SafetyFault::None);
  EXPECT_EQ(result.DrillProblem, "");
  EXPECT_GT(result.DrillOrders, 100u);
  const auto canal = [](double deep)
  {
    constexpr double R = DrillBlock::Sphere;
    const double across =
        R * R * std::acos(1.0 - deep / R) - (R - deep) * std::sqrt(2.0 * R * deep - deep * deep);
    return 6.0 * across + M_PI * deep * deep * (R - deep / 3.0);
  };
  EXPECT_LT(result.RemovedVolumes[0], 1.02 * canal(1.04)); // by a tenth of a voxel of clearance
  EXPECT_GT(result.RemovedVolumes[0], canal(0.45));
  EXPECT_GE(result.Removal.size(), 300u);
  EXPECT_EQ(result.Removal.front().Volumes[0], 0.0);
}

TEST(DrillRun, ReplayDrillsTheSameHolesBitForBit)
{
  const DrillBlock block;
  const std::filesystem::path recording = block.Folder / "session.touch";
  TouchScript script = DrillBlock::CanalAt(3.5);
  script.Actions = {{0.9, DrillAction::Kind::Start}, {3.0, DrillAction::Kind::EndStroke},
                    {4.0, DrillAction::Kind::Undo},  {4.5, DrillAction::Kind::Redo},
                    {6.0, DrillAction::Kind::Stop},  {6.5, DrillAction::Kind::Undo}};
  const PreparedTouch touch = test::Prepare(block.Settings(true), script);
  EXPECT_GT(Drilled(touch, recording).RemovedVolumes[0], 1.0);
  const PreparedTouch again = test::Prepare(block.Settings(true), script);
  const TouchComparison comparison = CompareTouch(again, recording);
  EXPECT_EQ(comparison.Ticks, 9000u);
  EXPECT_EQ(comparison.DifferentTicks, 0u);
  EXPECT_EQ(StateOf(again), StateOf(touch));
}

TEST(DrillRun, ForbiddenStructureIsNotRemovedAndRaisesAlarm)
{
  const DrillBlock block;
  std::vector<std::string> said;
  TouchRunSettings settings;
  settings.Guide = [&said](const std::string& message) { said.push_back(message); };
  const PreparedTouch touch = test::Prepare(block.Settings(true), DrillBlock::CanalAt(0.0));
  const TouchResult result = RunTouch(touch, settings, test::NeverCancels);
  ASSERT_EQ(result.Approaches.size(), 1u);
  EXPECT_EQ(result.Approaches[0].Name, "nerve");
  // The sphere may be a tenth of a voxel inside, and the mask's surface is accurate to a few
  // tenths.
  EXPECT_LT(result.Approaches[0].Least, 0.2);
  EXPECT_GT(result.Approaches[0].Least, -0.3 * DrillBlock::Spacing);
  EXPECT_GT(result.Approaches[0].AlarmSeconds, 1.0);
  ASSERT_FALSE(said.empty());
  // The distance in the message is less than the alarm distance.
  const std::string begin = "The drill is ";
  ASSERT_EQ(said[0].find(begin), 0u) << said[0];
  EXPECT_LT(std::stod(said[0].substr(begin.size())), 1.0) << said[0];
  EXPECT_NE(said[0].find(" mm from nerve, within the alarm distance of 1.0 mm."), std::string::npos)
      << said[0];
  const DrillReading reading = touch.Drill->Editor().Newest();
  std::shared_ptr<const FieldSolid> solid;
  ASSERT_TRUE(FieldSolid::Make(reading.Fields[0], 0, solid).IsOk());
  for (double y = -5.0; y <= 5.0; y += 0.5)
  {
    for (double angle = 0.0; angle < 6.2; angle += 0.3)
    {
      const Vector3 point(0.8 * std::cos(angle), y, 0.8 * std::sin(angle));
      unsigned char inside = 0;
      solid->AreInside(&point, 1, &inside);
      ASSERT_EQ(inside, 1) << point.transpose();
    }
  }
}

TEST(DrillRun, UndoingAllStrokesRestoresTheBone)
{
  const DrillBlock block;
  TouchScript script = DrillBlock::CanalAt(4.0);
  script.Actions.push_back({8.95, DrillAction::Kind::Undo});
  const PreparedTouch touch = test::Prepare(block.Settings(), script);
  const std::vector<std::byte> before = StateOf(touch);
  EXPECT_EQ(Drilled(touch).RemovedVolumes[0], 0.0);
  EXPECT_EQ(StateOf(touch), before);
}

// A stroke every five seconds, each tenth undone.
TEST(DrillRun, MinutesOfStrokesTakeBoundedMemory)
{
  const int strokes = test::ProofCount(24, 120);
  const DrillBlock block;
  std::vector<HandPath::Place> places{{0.0, {0.0, 0.0, 8.0}}};
  TouchScript script;
  for (int stroke = 0; stroke < strokes; ++stroke)
  {
    const double start = 5.0 * stroke;
    const Vector3 middle(4.0 * std::cos(0.7 * stroke), 4.0 * std::sin(1.1 * stroke), 0.0);
    const double depth = 4.6 - 6.0 * stroke / strokes;
    places.push_back({start + 0.5, middle + 8.0 * Vector3::UnitZ()});
    for (int n = 0; n < 20; ++n)
    {
      const Vector3 round(1.5 * std::cos(0.6 * n), 1.5 * std::sin(0.6 * n), depth);
      places.push_back({start + 1.0 + 0.15 * n, middle + round});
    }
    places.push_back({start + 4.5, middle + 8.0 * Vector3::UnitZ()});
    script.Actions.push_back({start + 0.6, DrillAction::Kind::Start});
    script.Actions.push_back({start + 4.4, DrillAction::Kind::Stop});
    if (stroke % 10 == 9)
    {
      script.Actions.push_back({start + 4.6, DrillAction::Kind::Undo});
    }
  }
  places.push_back({5.0 * strokes, {0.0, 0.0, 8.0}});
  script.Path = HandPath(std::move(places));
  const PreparedTouch touch = test::Prepare(block.Settings(), script);
  int reports = 0;
  double settled = 0.0; // MiB, after the first second
  const TouchResult result = RunTouch(touch, {},
                                      [&](double, const std::string&)
                                      {
                                        settled =
                                            ++reports == 2 ? test::ResidentMebibytes() : settled;
                                        return true;
                                      });
  EXPECT_EQ(result.Ticks, 5000u * static_cast<unsigned>(strokes));
  EXPECT_EQ(result.Fault, SafetyFault::None);
  EXPECT_GT(result.DrillOrders, 10000u * static_cast<unsigned>(strokes) / 120u);
  EXPECT_GT(result.RemovedVolumes[0], 50.0 * strokes / 120.0);
  // Strokes that can be undone keep their changes: a few hundred blocks of 2 kB each.
  ASSERT_GT(settled, 1.0);
  EXPECT_LT(test::ResidentMebibytes() - settled, 8.0 + 32.0 * strokes / 120.0);
  EXPECT_LT(touch.Drill->Editor().Bytes(), std::size_t{40} << 20);
}

TEST(DrillRun, EveryToolDrills)
{
  const DrillBlock block;
  for (const TouchToolSettings::Shape shape :
       {TouchToolSettings::Shape::Capsule, TouchToolSettings::Shape::Ellipsoid,
        TouchToolSettings::Shape::Cylinder})
  {
    SceneSettings settings = block.Settings();
    settings.Tool.Kind = shape;
    settings.Tool.Length = 2.0;
    settings.Tool.SemiAxes = Vector3(1.6, 1.6, 2.6);
    settings.Tool.Points = 200;
    const TouchResult result = Drilled(test::Prepare(settings, DrillBlock::CanalAt(4.5)));
    EXPECT_EQ(result.DrillProblem, "");
    EXPECT_GT(result.RemovedVolumes[0], 5.0) << static_cast<int>(shape);
  }
}

TEST(DrillRun, RejectsScenesThatCannotBeDrilled)
{
  const DrillBlock block;
  SceneSettings settings = block.Settings();
  settings.Structures[0].Drill.Wear = 0.0;
  EXPECT_EQ(Refusal(settings),
            "no structure of the scene is drilled; give one of its structures a \"drill\"");
  settings = block.Settings();
  settings.Tool.Radius = 0.0;
  EXPECT_EQ(Refusal(settings), "a point cannot drill; give the tool a radius above 0");
}

TEST(DrillRun, DrillingAlwaysUsesALinearField)
{
  const DrillBlock block;
  SceneSettings settings = block.Settings();
  settings.Structures[0].Interpolation = FieldInterpolation::TricubicBSpline;
  const PreparedTouch touch = test::Prepare(settings, DrillBlock::CanalAt(4.0));
  EXPECT_EQ(touch.Drill->Sites()[0].Source.Field->Interpolation(), FieldInterpolation::Trilinear);
}

TEST(DrillRun, SummaryHasRemovedVolumeAndForbiddenStructures)
{
  const DrillBlock block;
  const PreparedTouch touch = test::Prepare(block.Settings(true), DrillBlock::CanalAt(4.0));
  const TouchResult result = Drilled(touch);
  const nlohmann::json summary = nlohmann::json::parse(TouchSummaryText(touch, result));
  EXPECT_EQ(summary["drilled"]["removed"][0]["name"], "bone");
  EXPECT_EQ(summary["drilled"]["removed"][0]["mm3"], result.RemovedVolumes[0]);
  EXPECT_EQ(summary["drilled"]["forbidden"][0]["name"], "nerve");
}
} // namespace
} // namespace palpate::drill_run_test
