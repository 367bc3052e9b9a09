#include "CommandRun.h"
#include "JsonLines.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TestData.h"

#include <gtest/gtest.h>
#include <iterator>
#include <sstream>

namespace palpate::cli_info_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

// The words of the line that starts with `first`; empty if there is none.
std::vector<std::string> WordsOfLine(const std::string& text, const std::string& first)
{
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    std::istringstream words(line);
    std::vector<std::string> found{std::istream_iterator<std::string>(words), {}};
    if (!found.empty() && found.front() == first)
    {
      return found;
    }
  }
  return {};
}

TEST(CliInfo, TableListsLabels)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  const CommandRun run = RunPalpate({"info", "a.nii.gz"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(run.Errors, "");
  EXPECT_EQ(WordsOfLine(run.Output, "size"),
            (std::vector<std::string>{"size", "41", "x", "41", "x", "15", "voxels"}));
  EXPECT_EQ(WordsOfLine(run.Output, "holds")[1], "NIfTI");
  const std::vector<std::string> sphere = WordsOfLine(run.Output, "1");
  ASSERT_EQ(sphere.size(), 7u) << run.Output;
  EXPECT_EQ(sphere[3], "-");
  EXPECT_EQ(sphere[4], "1");
  EXPECT_EQ(sphere[5], "0");
}

TEST(CliInfo, JsonHasTheSameNumbers)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nrrd");
  const CommandRun run = RunPalpate({"info", "a.nrrd", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  const Json info = Json::parse(run.Output);
  EXPECT_EQ(info.at("status"), "ok");
  EXPECT_EQ(info.at("kind"), "NRRD label map");
  EXPECT_EQ(info.at("geometry").at("spacing_mm"), Json({1.0, 1.0, 2.5}));
  EXPECT_EQ(info.at("geometry").at("origin_mm"), Json({-20.0, -20.0, -17.5}));
  const Json& sphere = info.at("labels").at(0);
  EXPECT_EQ(sphere.at("label"), 1);
  EXPECT_EQ(sphere.at("touches_border"), false);
  EXPECT_EQ(sphere.at("component_voxels").at(0), sphere.at("voxels"));
  EXPECT_DOUBLE_EQ(sphere.at("ml").get<double>(), sphere.at("voxels").get<int>() * 2.5 / 1000.0);
}

TEST(CliInfo, BadFileDoesNotStopOthers)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "bad.nii", "");
  const CommandRun run =
      RunPalpate({"info", "bad.nii", "missing.nii", "a.nii.gz", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 1);
  EXPECT_EQ(run.Errors, "palpate: bad.nii is empty; copy or export it again.\n"
                        "palpate: missing.nii does not exist; check the path.\n");
  const std::vector<Json> objects = Lines(run.Output);
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0].at("status"), "bad-input");
  EXPECT_EQ(objects[1].at("message"), "missing.nii does not exist; check the path.");
  EXPECT_EQ(objects[2].at("status"), "ok");
}

TEST(CliInfo, ChoosesAnotherSeries)
{
  const auto path = DataPath("prostate/dicom_localizer_three_planes");
  PALPATE_REQUIRE_FILE(path);
  const TemporaryFolder folder;
  EXPECT_EQ(RunPalpate({"info", path.string()}, folder.Path()).Code, 2);
  const CommandRun run =
      RunPalpate({"info", path.string(), "--series", "3", "--json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(Json::parse(run.Output).at("geometry").at("axes").at(2), Json({0.0, 0.0, 1.0}));
}

TEST(CliInfo, DoesNotShowPatientNames)
{
  const auto path = DataPath("prostate/dicom_t2_axial");
  PALPATE_REQUIRE_FILE(path);
  const TemporaryFolder folder;
  const CommandRun run = RunPalpate({"info", path.string()}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  // PatientName of the series' headers.
  EXPECT_EQ(run.Output.find("PCAMRGBX"), std::string::npos);
}
} // namespace
} // namespace palpate::cli_info_test
