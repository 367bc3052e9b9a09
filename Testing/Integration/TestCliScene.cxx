#include "CommandRun.h"
#include "JsonLines.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_scene_test
{
namespace
{
using namespace palpate::test;

// Two spheres of a mask, a model that is only touched, and a missing file.
void WriteScene(const TemporaryFolder& folder)
{
  WriteTwoSpheres(folder / "a.nii.gz");
  WriteNearlyASphere(folder / "ball.json");
  WriteAll(folder / "all.scene.json",
           R"({"format": "palpate-scene", "structures": [
               {"file": "a.nii.gz", "label": "1", "name": "both"},
               {"file": "a.nii.gz", "label": "2", "name": "eye", "touched": false},
               {"file": "ball.json", "name": "hand", "seen": false},
               {"file": "missing.nii.gz", "name": "none", "seen": false, "touched": false}]})");
}

TEST(CliScene, ExplainsWhatWasBuiltAndSkipped)
{
  const TemporaryFolder folder;
  WriteScene(folder);
  const CommandRun run =
      RunPalpate({"scene", "explain", "all.scene.json", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const nlohmann::json said = nlohmann::json::parse(run.Output);
  ASSERT_EQ(said["files"].size(), 3U);
  EXPECT_FALSE(said["files"][2]["read"]["made"].get<bool>());
  const std::vector<bool> made{true, false, true, false};
  ASSERT_EQ(said["structures"].size(), made.size());
  for (std::size_t s = 0; s < made.size(); ++s)
  {
    const nlohmann::json& item = said["structures"][s]["touch"];
    EXPECT_EQ(item["made"].get<bool>(), made[s]) << said["structures"][s]["name"];
    EXPECT_EQ(item.contains("why_not"), !item["made"].get<bool>());
    EXPECT_EQ(item.contains("bytes"), item["made"].get<bool>());
  }
  EXPECT_EQ(said["total"]["touch"]["made"], 2);
  EXPECT_GT(said["servo"]["bytes"].get<int>(), 1000);
  EXPECT_GT(said["total"]["touch"]["bytes"].get<int>(), 1000);
}

TEST(CliScene, PrintsSummaryAsText)
{
  const TemporaryFolder folder;
  WriteScene(folder);
  const CommandRun run = RunPalpate({"scene", "explain", "all.scene.json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  for (const char* words : {"not opened", "not touched in the scene", "sub-voxel field",
                            "2 of 3 files read", "2 of 4 structures touchable"})
  {
    EXPECT_NE(run.Output.find(words), std::string::npos) << words << " in\n" << run.Output;
  }
  EXPECT_EQ(folder.EntryCount(), 3U) << "nothing is written";
}

TEST(CliScene, TouchBuildsOnlyRequiredParts)
{
  const TemporaryFolder folder;
  WriteScene(folder);
  const CommandRun run =
      RunPalpate({"touch", "all.scene.json", "--seconds", "0.2", "--json"}, folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(nlohmann::json::parse(run.Output)["structures"].size(), 2U);
}

TEST(CliScene, RejectsMalformedScene)
{
  const TemporaryFolder folder;
  WriteScene(folder);
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"scene"},
                                             {"scene", "explain"},
                                             {"scene", "describe", "all.scene.json"},
                                             {"scene", "explain", "missing.scene.json"},
                                             {"scene", "explain", "ball.json"}})
  {
    EXPECT_EQ(RunPalpate(arguments, folder.Path()).Code, 2) << arguments.back();
  }
}
} // namespace
} // namespace palpate::cli_scene_test
