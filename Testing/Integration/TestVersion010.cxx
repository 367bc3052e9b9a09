// Files of version 0.1.0, made by that program: they open, and the recording is replayed.
#include "CommandRun.h"

#include "ModelFile.h"
#include "StudyFile.h"

#include <gtest/gtest.h>

namespace palpate::version010_test
{
namespace
{
const std::filesystem::path Folder = PALPATE_VERSION_010;

// N; what a replay says that forces differ by.
double LargestDifference(const test::CommandRun& run)
{
  const std::string words = "forces by at most ";
  const std::size_t at = run.Output.find(words);
  EXPECT_NE(at, std::string::npos) << run.Output << run.Errors;
  return at == std::string::npos ? 1e9 : std::stod(run.Output.substr(at + words.size()));
}

// With the model that 0.1.0 fitted to the mask, by a program of GCC 12. Other compilers (not GCC
// 14) fuse other products and sums in the kernels that may be fused: a few units in the last place.
TEST(Version010, RecordingReplaysBitForBit)
{
  const test::CommandRun run =
      test::RunPalpate({"touch", "model.scene.json", "--replay", "touch.touch"}, Folder);
#if defined(__clang__) || __GNUC__ > 14
  EXPECT_LT(LargestDifference(run), 1e-13);
#else
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("0 of 600 ticks differ"), std::string::npos) << run.Output;
#endif
}

// Today's fit follows the mask's slices more closely, by up to 0.03 mm at 0.3 N/mm.
TEST(Version010, RecordingReplaysOnTodaysFitWithNearlyTheSameForces)
{
  const test::CommandRun run =
      test::RunPalpate({"touch", "scene.json", "--replay", "touch.touch"}, Folder);
  EXPECT_LT(LargestDifference(run), 0.01) << run.Output; // N
}

TEST(Version010, TouchesSceneWithEveryKey)
{
  const test::CommandRun run =
      test::RunPalpate({"touch", "keys.scene.json", "--seconds", "0.05", "--json"}, Folder);
  EXPECT_EQ(run.Code, 0) << run.Errors;
}

TEST(Version010, ModelOpens)
{
  const ModelDocument document = ReadModel(Folder / "model.json");
  const auto& model = std::get<RadialModel>(document.Surface);
  EXPECT_EQ(model.Degree(), 6);
  EXPECT_EQ(model.Coefficients()[0], 76.62410670927625);
}

TEST(Version010, SessionOpens)
{
  const StudyState state = ReadStudy(Folder / "session.palpate.json");
  EXPECT_TRUE(std::filesystem::exists(state.VolumeFile));
  EXPECT_TRUE(std::filesystem::exists(state.SegmentationFile));
  ASSERT_EQ(state.Structures.size(), 1U);
  const SceneStructure& gland = state.Structures.front();
  EXPECT_EQ(gland.Name, "gland");
  EXPECT_EQ(gland.Appearance, SceneAppearance::ErrorMap);
  EXPECT_EQ(gland.Degree, 8); // as set by its preset, regardless of the structure
  EXPECT_EQ(gland.Representation, TouchRepresentation::ModelOrField);
  EXPECT_EQ(gland.Stiffness, 0.7);
  EXPECT_EQ(gland.Friction.Static, 0.4);
  EXPECT_EQ(gland.Drill.Wear, 0.1);
  EXPECT_EQ(state.Fit.Frequency, 10);
  EXPECT_EQ(state.Tool.Radius, 1.25);
  EXPECT_EQ(state.Rate, 2000.0);
  EXPECT_EQ(state.Placement.CenterWorld, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(state.Landmarks.at(0).PositionWorld, Vector3(1.5, -2.25, 3.125));
  EXPECT_EQ(state.Measurements.at(0).Kind, MeasurementKind::Line);
  EXPECT_EQ(ValueOf(state.Measurements.at(0)), 5.0);
  EXPECT_EQ(state.View.Window, 200.0);
}
} // namespace
} // namespace palpate::version010_test
