#include "CommandRun.h"
#include "JsonLines.h"
#include "ModelFile.h"
#include "ModelMeasures.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TwoVolumes.h"

#include <fstream>
#include <gtest/gtest.h>

namespace palpate::cli_fit_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(CliFit, OneStructureGivesNumbersFilesAndReport)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--degree", "6", "--output", "out", "--json"},
                 folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json result = Json::parse(run.Output);
  EXPECT_EQ(result.at("input"), "a.nii.gz");
  EXPECT_EQ(result.at("label"), 1);
  EXPECT_EQ(result.at("degree"), 6);
  EXPECT_EQ(result.at("status"), "fitted");
  EXPECT_EQ(result.at("message"), "");
  EXPECT_LT(result.at("star").at("hidden_percent").get<double>(), 0.1);
  EXPECT_GE(result.at("fit").at("condition").get<double>(), 1.0);
  EXPECT_GT(result.at("fit").at("rms_mm").get<double>(), 0.0);
  const Json& mask = result.at("quality").at("mask");
  EXPECT_GT(mask.at("dice").get<double>(), 0.95);
  EXPECT_LE(mask.at("mean_mm").get<double>(), mask.at("p95_mm").get<double>());
  EXPECT_LE(mask.at("p95_mm").get<double>(), mask.at("max_mm").get<double>());
  // A sphere of 9 mm, on a grid whose voxels are a quarter of it.
  EXPECT_NEAR(result.at("volume_ml").at("mask").get<double>(), 3.054, 0.2);
  EXPECT_NEAR(result.at("volume_ml").at("model").get<double>(),
              result.at("volume_ml").at("mask").get<double>(), 0.03);
  EXPECT_GT(result.at("seconds").at("total").get<double>(), 0.0);
  EXPECT_TRUE(result.at("seconds").contains("surface"));
  for (const char* file : {"model.json", "model.csv", "model.vtp", "surface.vtp", "report.html"})
  {
    EXPECT_TRUE(std::filesystem::exists(folder / "out" / file)) << file;
  }
  const auto document = palpate::ReadModel(folder / "out" / "model.json");
  const auto& model = std::get<palpate::RadialModel>(document.Surface);
  EXPECT_EQ(model.Degree(), 6);
  // Report and JSON agree with the model's file.
  EXPECT_DOUBLE_EQ(VolumeOf(model) / 1000.0, result.at("volume_ml").at("model").get<double>());
}

TEST(CliFit, MapOfSeveralVolumesIsChosenByNumber)
{
  const TemporaryFolder folder;
  WriteTwoVolumes(folder / "a.nii");
  // Of balls of 6 and 9 mm; their voxels miss them by some hundredths.
  for (const auto& [number, milliliters] : {std::pair("1", 0.905), std::pair("2", 3.054)})
  {
    const CommandRun run = RunPalpate(
        {"fit", "a.nii", "--series", number, "--degree", "4", "--output", "out", "--json"},
        folder.Path());
    ASSERT_EQ(run.Code, 0) << run.Errors;
    EXPECT_NEAR(Json::parse(run.Output).at("volume_ml").at("mask").get<double>(), milliliters,
                0.05 * milliliters);
  }
}

TEST(CliFit, EveryLabelHasFolderAndOverview)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"fit", "a.nii.gz", "--degree", "4", "--output", "out", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(Lines(run.Output).size(), 2U);
  EXPECT_TRUE(std::filesystem::exists(folder / "out/report.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a_1/report.html"));
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a_2/model.json"));
}

TEST(CliFit, FailingCaseIsReportedLastAndDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "good.nii.gz");
  std::ofstream(folder / "bad.nii.gz") << "no image";
  const CommandRun run = RunPalpate({"fit", "bad.nii.gz", "missing.nrrd", "good.nii.gz", "--label",
                                     "1", "--degree", "4", "--json"},
                                    folder.Path());
  EXPECT_EQ(run.Code, 1);
  const auto results = Lines(run.Output);
  ASSERT_EQ(results.size(), 3U);
  EXPECT_EQ(results[0].at("status"), "bad-input");
  EXPECT_TRUE(results[0].at("quality").at("mask").at("dice").is_null());
  EXPECT_EQ(results[2].at("status"), "fitted");
  EXPECT_TRUE(Has(run.Errors, "2 of 3 cases were not fitted")) << run.Errors;
}

TEST(CliFit, BadInputGivesOneMessageAndLeavesNothing)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const std::vector<std::pair<std::vector<std::string>, std::string>> cases{
      {{"missing.nii.gz"}, "missing.nii.gz"},
      {{"a.nii.gz", "--label", "7"}, "1, 2"},
      {{"a.nii.gz", "--label", "Prostate"}, "Prostate"},
      {{"a.nii.gz", "--degree", "x"}, "--degree"},
      {{"a.nii.gz", "--degree", "-1"}, "--degree"},
      {{"a.nii.gz", "--center", "1,2"}, "--center"},
      {{"a.nii.gz", "--penalty", "-3"}, "--penalty"},
      {{"a.nii.gz", "--component", "0"}, "--component"},
      {{"a.nii.gz", "--tolerance", "0.1"}, "--degree auto"},
      {{"a.nii.gz", "--volume", "missing.nii"}, "missing.nii"},
      {{"a.nii.gz", "--frequency", "0"}, "--frequency"},
      {{}, "MASK"}};
  for (const auto& [arguments, part] : cases)
  {
    std::vector<std::string> all{"fit", "--output", "out"};
    all.insert(all.end(), arguments.begin(), arguments.end());
    const CommandRun run = RunPalpate(all, folder.Path());
    EXPECT_EQ(run.Code, 2) << part;
    EXPECT_TRUE(Has(run.Errors, part)) << run.Errors;
    EXPECT_EQ(std::count(run.Errors.begin(), run.Errors.end(), '\n'), 1) << run.Errors;
    EXPECT_FALSE(std::filesystem::exists(folder / "out"));
  }
}

TEST(CliFit, UnwritableOutputIsBadInput)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  std::ofstream(folder / "file") << "in the way";
  const CommandRun run = RunPalpate(
      {"fit", "a.nii.gz", "--label", "1", "--degree", "4", "--output", "file/out"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_TRUE(Has(run.Errors, "file/out")) << run.Errors;
}

TEST(CliFit, RejectsFewerDirectionsThanCoefficientsWithFix)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"fit", "a.nii.gz", "--label", "1", "--degree", "12", "--frequency", "3"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  EXPECT_TRUE(Has(run.Errors, "take more directions or a lower degree")) << run.Errors;
}

TEST(CliFit, RefusesOptionsWithoutEffect)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const auto refusal = [&](std::vector<std::string> words)
  {
    words.insert(words.begin(), {"fit", "a.nii.gz"});
    const CommandRun run = RunPalpate(words, folder.Path());
    EXPECT_EQ(run.Code, 2);
    return run.Errors;
  };
  EXPECT_TRUE(Has(refusal({"--tolerance", "1"}), "--tolerance needs --degree auto"));
  EXPECT_TRUE(
      Has(refusal({"--model", "radial", "--repair", "--rules", "1"}), "leave out --repair"));
  EXPECT_TRUE(Has(refusal({"--max-degree", "3"}), "--max-degree needs --degree auto"));
  EXPECT_TRUE(
      Has(refusal({"--model", "surface", "--center", "visible"}), "--center is for radial"));
}

TEST(CliFit, SurfaceModelsAreNotSearchedBelowDegreeOne)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate({"fit", "a.nii.gz", "--label", "1", "--model", "surface",
                                     "--degree", "auto", "--max-degree", "0"},
                                    folder.Path());
  EXPECT_EQ(run.Code, 1);
  EXPECT_TRUE(Has(run.Errors, "needs more than degree 0")) << run.Errors;
}

TEST(CliFit, BadInputNamesTheModelThatWasAskedFor)
{
  const TemporaryFolder folder;
  const CommandRun run =
      RunPalpate({"fit", "none.nii.gz", "--model", "surface", "--json"}, folder.Path());
  EXPECT_TRUE(Has(run.Output, R"("model":"surface")")) << run.Output;
}

TEST(CliFit, AutoDegreeIsSmallestWithinTolerance)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"fit", "a.nii.gz", "--label", "1", "--degree", "auto", "--tolerance", "0.3", "--json"},
      folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json result = Json::parse(run.Output);
  EXPECT_LE(result.at("fit").at("rms_mm").get<double>(), 0.3);
  const auto degree = result.at("degree").get<std::size_t>();
  if (degree > 0)
  {
    EXPECT_GT(result.at("fit").at("rms_by_degree_mm").at(degree - 1).get<double>(), 0.3);
  }
}

TEST(CliFit, AcceptsPenaltiesAndCentres)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--degree", "8", "--penalty", "auto",
                  "--center", "1,-1,0.5", "--weights", "solid-angle", "--json"},
                 folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json fit = Json::parse(run.Output).at("fit");
  EXPECT_GT(fit.at("roughness").get<double>(), 0.0);
  EXPECT_LT(fit.at("degrees_of_freedom").get<double>(), 81.0);
  EXPECT_EQ(fit.at("center_mm"), Json({1.0, -1.0, 0.5}));
}

TEST(CliFit, RobustFitReportsDownWeightedSamples)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate(
      {"fit", "a.nii.gz", "--label", "1", "--degree", "4", "--robust", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json fit = Json::parse(run.Output).at("fit");
  EXPECT_GT(fit.at("down_weighted").get<int>(), 0);
  EXPECT_EQ(fit.at("coverage").at("verdict"), "good");
}

// Seen from outside, the sphere covers only a part of all directions.
TEST(CliFit, DirectionGapGivesNoteAndVerdict)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run =
      RunPalpate({"fit", "a.nii.gz", "--label", "1", "--degree", "4", "--penalty", "0.001",
                  "--center", "0,0,40", "--max-hidden", "100", "--min-dice", "0", "--json"},
                 folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const Json result = Json::parse(run.Output);
  const Json& coverage = result.at("fit").at("coverage");
  EXPECT_EQ(coverage.at("verdict"), "gaps");
  EXPECT_GT(coverage.at("largest_gap_degrees").get<double>(), 45.0); // 180 divided by the degree
  EXPECT_TRUE(Has(run.Errors, "No direction within")) << run.Errors;
}
} // namespace
} // namespace palpate::cli_fit_test
