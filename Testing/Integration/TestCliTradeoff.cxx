#include "CommandRun.h"
#include "CsvRecords.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace palpate::cli_tradeoff_test
{
namespace
{
using namespace palpate::test;

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

/// A model and a mask; short paths, since the times are not checked.
class CliTradeoff : public testing::Test
{
protected:
  CliTradeoff()
  {
    WriteNearlyASphere(this->Folder / "ball.json");
    WriteTwoSpheres(this->Folder / "a.nii.gz");
  }
  CommandRun Run(std::vector<std::string> arguments) const
  {
    arguments.insert(arguments.begin(), "tradeoff");
    arguments.insert(arguments.end(), {"--seconds", "0.5", "--runs", "1"});
    return RunPalpate(arguments, this->Folder.Path());
  }
  std::vector<palpate::CsvRecord> Rows(const std::string& folder) const
  {
    return palpate::test::CsvRecordsIn(ReadAll(this->Folder / (folder + "/tradeoff.csv")));
  }

  TemporaryFolder Folder;
};

TEST_F(CliTradeoff, RecommendsASettingAndWritesTableAndPage)
{
  const CommandRun run = this->Run({"a.nii.gz", "--label", "1", "-o", "out"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "label 1: choose ")) << run.Output;
  EXPECT_TRUE(Has(run.Output, "sub-voxel, tricubic")) << run.Output;
  EXPECT_GT(this->Rows("out").size(), 4U);
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/tradeoff.html"), "</html>"));
  const auto json = nlohmann::json::parse(ReadAll(this->Folder / "out/tradeoff.json"));
  EXPECT_EQ(json["format"], "palpate-tradeoff");
}

TEST_F(CliTradeoff, WritesTheSceneWithTheAdvisedSettings)
{
  ASSERT_EQ(this->Run({"a.nii.gz", "--label", "1", "-o", "out"}).Code, 0);
  const auto scene = nlohmann::json::parse(ReadAll(this->Folder / "out/advised.scene.json"));
  const auto json = nlohmann::json::parse(ReadAll(this->Folder / "out/tradeoff.json"));
  const std::string chosen = json["structures"][0]["advice"]["choose"];
  const std::string representation = scene["structures"][0]["representation"];
  EXPECT_EQ(chosen.substr(0, chosen.find('/')), representation);
  const CommandRun run =
      RunPalpate({"scene", "explain", "out/advised.scene.json"}, this->Folder.Path());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(Has(run.Output, "1 of 1 structures touchable")) << run.Output;
}

TEST_F(CliTradeoff, PrintsOnlyJsonOnStandardOutput)
{
  const CommandRun run = this->Run({"ball.json", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const nlohmann::json said = nlohmann::json::parse(run.Output);
  EXPECT_EQ(said["structures"].size(), 1U);
  EXPECT_EQ(said["path"]["seconds"], 0.5);
}

TEST_F(CliTradeoff, MeasuresTheNamedStructureOfAScene)
{
  WriteAll(this->Folder / "two.scene.json",
           R"({"format": "palpate-scene", "tool": {"radius_mm": 1}, "structures": [
               {"file": "ball.json", "name": "ball"},
               {"file": "a.nii.gz", "label": "2", "name": "pea", "touched": false}]})");
  const CommandRun run = this->Run({"two.scene.json", "--structure", "ball", "--json"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_EQ(nlohmann::json::parse(run.Output)["tool_radius_mm"], 1.0);
  const CommandRun unknown = this->Run({"two.scene.json", "--structure", "pea"});
  EXPECT_EQ(unknown.Code, 2);
  EXPECT_TRUE(Has(unknown.Errors, "name one of ball")) << unknown.Errors;
}

TEST_F(CliTradeoff, MeasuresAStructureThatYieldsByItsForce)
{
  WriteAll(this->Folder / "soft.scene.json",
           R"({"format": "palpate-scene", "tool": {"radius_mm": 4}, "structures": [
               {"file": "ball.json", "representation": "elastic", "elements_across": 4}]})");
  const CommandRun run = this->Run({"soft.scene.json", "-o", "out"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_TRUE(
      Has(run.Output, "elastic, 4 elements across, compliance of automatic degree, maps of degree"))
      << run.Output;
  EXPECT_TRUE(Has(run.Output, "rigid, harmonics")) << run.Output;
  EXPECT_TRUE(Has(run.Output, "N off")) << run.Output;
  EXPECT_TRUE(Has(run.Output, "The structure yields")) << run.Output;
  EXPECT_TRUE(Has(ReadAll(this->Folder / "out/tradeoff.html"), "Force, mN"));
}

TEST_F(CliTradeoff, RejectsBadInputWithOneMessage)
{
  const std::vector<std::vector<std::string>> bad{{"missing.json"},
                                                  {"a.nii.gz", "--label", "9"},
                                                  {"a.nii.gz", "--iso", "nan"},
                                                  {"a.nii.gz", "--structure", "nobody"},
                                                  {"ball.json", "--tool-radius", "-1"},
                                                  {"ball.json", "--output", "a.nii.gz"}};
  for (const std::vector<std::string>& arguments : bad)
  {
    const CommandRun run = this->Run(arguments);
    EXPECT_EQ(run.Code, 2) << arguments.back() << run.Errors;
    EXPECT_TRUE(Has(run.Errors, "palpate: ")) << run.Errors;
  }
}
} // namespace
} // namespace palpate::cli_tradeoff_test
