#include "CommandRun.h"
#include "IcosahedronDirections.h"
#include "ModelMeasures.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TestData.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_evaluate_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

Vector3 AsVector(const Json& list)
{
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

Json Evaluate(const TemporaryFolder& folder, std::vector<std::string> more)
{
  WriteNearlyASphere(folder / "a.json");
  std::vector<std::string> words{"evaluate", "a.json", "--json"};
  words.insert(words.end(), more.begin(), more.end());
  const CommandRun run = RunPalpate(words, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Errors, "");
  return Json::parse(run.Output);
}

TEST(CliEvaluate, JsonNumbersEqualKernelsBitForBit)
{
  const TemporaryFolder folder;
  const Json result = Evaluate(folder, {"--direction", "0,0,-2"});
  const RadialModel model = NearlyASphere();
  const Vector3 down(0.0, 0.0, -1.0);
  EXPECT_EQ(result.at("degree"), 1);
  EXPECT_EQ(result.at("volume_ml").get<double>(), VolumeOf(model) / 1000.0);
  EXPECT_EQ(result.at("area_mm2").get<double>(), AreaOf(model));
  EXPECT_EQ(result.at("power_mm2").get<std::vector<double>>(), model.PowerSpectrum());
  EXPECT_EQ(AsVector(result.at("center_mm")), model.CenterWorld());
  const Json& sample = result.at("directions").at(0);
  EXPECT_EQ(AsVector(sample.at("direction")), down);
  EXPECT_EQ(sample.at("radius_mm").get<double>(), model.Radius(down));
  EXPECT_EQ(AsVector(sample.at("gradient_mm_per_rad")), model.Evaluate(down).SurfaceGradient);
  EXPECT_EQ(AsVector(sample.at("point_mm")), model.PointWorld(down));
  EXPECT_EQ(AsVector(sample.at("normal")), model.Normal(down));
}

TEST(CliEvaluate, ClassifiesPointsInsideAndOutside)
{
  const TemporaryFolder folder;
  const Json result =
      Evaluate(folder, {"--point", "1,2,3", "--point", "1,2,8", "--point", "1,22,3"});
  const double up = NearlyASphere().Radius(Vector3::UnitZ());
  const Json& points = result.at("points");
  ASSERT_EQ(points.size(), 3u);
  EXPECT_EQ(points[0].at("inside"), true);
  EXPECT_EQ(points[0].at("radial_distance_mm").get<double>(), -up);
  EXPECT_EQ(points[1].at("inside"), true);
  EXPECT_EQ(points[1].at("radial_distance_mm").get<double>(), 5.0 - up);
  EXPECT_EQ(points[2].at("inside"), false);
  EXPECT_NEAR(points[2].at("radial_distance_mm").get<double>(), 10.0, 1e-13); // rounding at 20
}

TEST(CliEvaluate, FrequencyGivesIcosahedronDirections)
{
  const TemporaryFolder folder;
  EXPECT_EQ(Evaluate(folder, {"--frequency", "20"}).at("directions").size(), 4002u);
}

TEST(CliEvaluate, DirectionMayHaveAnyLength)
{
  const TemporaryFolder folder;
  const Json directions = Evaluate(folder, {"--direction", "0, -3e-200 ,0"}).at("directions");
  EXPECT_EQ(AsVector(directions.at(0).at("direction")), Vector3(0.0, -1.0, 0.0));
}

TEST(CliEvaluate, TextStatesUnitsAndFrame)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  const CommandRun run =
      RunPalpate({"evaluate", "a.json", "--direction", "1,0,0", "--point", "0,0,0"}, folder.Path());
  EXPECT_EQ(run.Code, 0);
  for (const char* word : {"patient LPS", "ml", "mm^2", "radius mm", "inside"})
  {
    EXPECT_NE(run.Output.find(word), std::string::npos) << word;
  }
}

TEST(CliEvaluate, SurfaceModelHasSameVolumeAndArea)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  RunPalpate({"convert", "a.json", "a.coef"}, folder.Path());
  const Json result =
      Json::parse(RunPalpate({"evaluate", "a.coef", "--json"}, folder.Path()).Output);
  const RadialModel model = NearlyASphere();
  EXPECT_EQ(result.at("kind"), "surface");
  EXPECT_EQ(result.at("inside_out"), false);
  // Both are sums of some hundred terms of equal magnitude.
  EXPECT_NEAR(result.at("volume_ml").get<double>(), VolumeOf(model) / 1000.0, 1e-12);
  EXPECT_NEAR(result.at("area_mm2").get<double>(), AreaOf(model), 1e-9);
}

// The same sphere, seen by its nearest points instead of its radii.
TEST(CliEvaluate, SurfaceModelKnowsInsideAndDistance)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  RunPalpate({"convert", "a.json", "a.coef"}, folder.Path());
  const Json result = Json::parse(
      RunPalpate({"evaluate", "a.coef", "--json", "--point", "1,2,3", "--point", "1,2,80"},
                 folder.Path())
          .Output);
  const Json& points = result.at("points");
  ASSERT_EQ(points.size(), 2U);
  EXPECT_EQ(points[0].at("inside"), true);
  EXPECT_LT(points[0].at("distance_mm").get<double>(), 0.0);
  EXPECT_EQ(points[1].at("inside"), false);
  const Vector3 far(1.0, 2.0, 80.0);
  double least = 1e300;
  const IcosahedronDirections grid(100);
  for (const Vector3& u : grid.Directions())
  {
    least = std::min(least, (NearlyASphere().PointWorld(u) - far).norm());
  }
  // The nearest direction may be 0.011 rad off, 0.11 mm on the sphere: 0.11^2 / 2 / 10 mm farther.
  EXPECT_NEAR(points[1].at("distance_mm").get<double>(), least, 1e-3);
  EXPECT_EQ(points[1].count("radius_mm"), 0U);
}

TEST(CliEvaluate, RejectsBadArgumentsWithOneMessage)
{
  const TemporaryFolder folder;
  WriteNearlyASphere(folder / "a.json");
  RunPalpate({"convert", "a.json", "a.coef"}, folder.Path());
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"a.json", "--direction", "0,0,0"},
                                             {"a.json", "--direction", "1,2"},
                                             {"a.json", "--direction", "1,2,3,4"},
                                             {"a.json", "--direction", "1,nan,3"},
                                             {"a.json", "--point", "x,y,z"},
                                             {"none.json"},
                                             {"a.txt"}})
  {
    std::vector<std::string> words{"evaluate"};
    words.insert(words.end(), more.begin(), more.end());
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2) << run.Errors;
    EXPECT_EQ(run.Output, "");
    EXPECT_EQ(run.Errors.find('\n'), run.Errors.size() - 1) << run.Errors;
  }
}
} // namespace
} // namespace palpate::cli_evaluate_test
