#include "CommandRun.h"
#include "JsonLines.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_study_test
{
namespace
{
using namespace palpate::test;

const std::string Start = "{\"format\": \"palpate-study\", \"fit\": {\"frequency\": 10}, ";

TEST(CliStudy, BuildsSessionThatCanBeTouched)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "case.palpate.json",
           Start + "\"segmentation\": \"a.nii.gz\", \"structures\": [{\"label\": 1, \"degree\": 4, "
                   "\"name\": \"ball\"}]}");
  const CommandRun run =
      RunPalpate({"study", "case.palpate.json", "--output", "out", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("harmonics of degree 4"), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("\"tick_us\":"), std::string::npos) << run.Output;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a_1_ball/model.json"));
  const CommandRun touch =
      RunPalpate({"touch", "out/scene.json", "--seconds", "0.2"}, folder.Path());
  EXPECT_EQ(touch.Code, 0) << touch.Errors;
}

TEST(CliStudy, SessionWithoutStructuresUsesAllOfItsFiles)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "case.palpate.json", Start + "\"segmentation\": \"a.nii.gz\"}");
  const CommandRun run = RunPalpate({"study", "case.palpate.json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("label 2 "), std::string::npos) << run.Output;
  EXPECT_EQ(folder.EntryCount(), 2U) << "nothing is written unasked";
}

// A sphere of one radius differs from the mask's steps: no model is close enough.
TEST(CliStudy, FallbackForRefusedModelIsNotFailure)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "case.palpate.json",
           "{\"format\": \"palpate-study\", \"fit\": {\"frequency\": 10, \"min_dice\": 1.0}, "
           "\"segmentation\": \"a.nii.gz\", \"structures\": [{\"label\": 1, \"degree\": 0, "
           "\"name\": \"ball\", \"shown_as\": \"sub-voxel\"}]}");
  const CommandRun run = RunPalpate({"study", "case.palpate.json"}, folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(
      run.Errors.find(
          "ball: touched by its sub-voxel field, because it is not matched by a model of degree 0"),
      std::string::npos)
      << run.Errors;
  EXPECT_NE(run.Output.find("shown as sub-voxel volume"), std::string::npos) << run.Output;
}

// The message is that of the file's own command.
TEST(CliStudy, BadFilesGiveUsualMessages)
{
  const TemporaryFolder folder;
  WriteAll(folder / "a.nii.gz", "no image");
  WriteAll(folder / "case.palpate.json", Start + "\"segmentation\": \"a.nii.gz\"}");
  const CommandRun run =
      RunPalpate({"study", "case.palpate.json", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 2);
  const CommandRun fit = RunPalpate({"fit", (folder / "a.nii.gz").string()}, folder.Path());
  EXPECT_EQ(run.Errors, fit.Errors);
  EXPECT_EQ(folder.EntryCount(), 2U);
}

TEST(CliStudy, RejectsMalformedSession)
{
  const TemporaryFolder folder;
  WriteAll(folder / "bad.palpate.json", "{\"format\": 1}");
  for (const char* name : {"bad.palpate.json", "missing.palpate.json"})
  {
    const CommandRun run = RunPalpate({"study", name}, folder.Path());
    EXPECT_EQ(run.Code, 2) << run.Errors;
    EXPECT_NE(run.Errors.find(name), std::string::npos) << run.Errors;
  }
}

TEST(CliStudy, FailedStructureIsReportedAndOthersWritten)
{
  const TemporaryFolder folder;
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteAll(folder / "case.palpate.json",
           Start + "\"segmentation\": \"a.nii.gz\", \"structures\": [{\"label\": 1}, {\"label\": "
                   "9}]}");
  const CommandRun run =
      RunPalpate({"study", "case.palpate.json", "--output", "out"}, folder.Path());
  EXPECT_EQ(run.Code, 1) << run.Errors;
  EXPECT_NE(run.Errors.find("9"), std::string::npos) << run.Errors;
  EXPECT_NE(run.Output.find("label 1 "), std::string::npos) << run.Output;
  EXPECT_TRUE(std::filesystem::exists(folder / "out/a_1/model.json"));
}
} // namespace
} // namespace palpate::cli_study_test
