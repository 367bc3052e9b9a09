#include "CommandRun.h"
#include "DrillBlock.h"
#include "HeadCt.h"
#include "SyntheticFiles.h"

#include <cstdlib>
#include <fstream>
#include <nlohmann/json.hpp>

namespace palpate::cli_drill_test
{
namespace
{
using namespace palpate::test;

// A block with a nerve, a hand motion down into it, and a pedal.
class CliDrill : public testing::Test
{
protected:
  void SetUp() override
  {
    std::ofstream(this->Folder() / "block.scene.json") << R"({"format": "palpate-scene",
      "structures": [
        {"name": "bone", "file": "ct.nrrd", "iso": 750, "drill": {"wear_mm_per_nm": 0.5}},
        {"name": "nerve", "file": "nerve.nrrd", "touched": false, "seen": false,
         "forbidden": true, "alarm_mm": 1.0}],
      "tool": {"shape": "sphere", "radius_mm": 1.6, "points": 0}, "scale": 1})";
    std::ofstream(this->Folder() / "hand.csv") << "time_s,x_mm,y_mm,z_mm\n"
                                                  "0,0,0,8\n1,0,0,5.8\n4,0,0,0\n5,0,0,8\n";
    std::ofstream(this->Folder() / "pedal.json") << R"({"format": "palpate-drill",
      "actions": [{"time_s": 0.5, "do": "start"}, {"time_s": 4.5, "do": "stop"}]})";
  }
  std::filesystem::path Folder() const { return this->Block.Folder.Path(); }
  CommandRun Run(std::vector<std::string> more) const
  {
    std::vector<std::string> arguments{"touch", "block.scene.json", "--path", "hand.csv"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return RunPalpate(arguments, this->Folder());
  }

  DrillBlock Block;
};

TEST_F(CliDrill, BallOnAShaftRemovesWhatASphereDoes)
{
  const auto removed = [&](const std::string& name)
  {
    const CommandRun run = this->Run({"--drill", "pedal.json", "--output", name});
    EXPECT_EQ(run.Code, 0) << run.Errors;
    const nlohmann::json summary =
        nlohmann::json::parse(ReadAll(this->Folder() / name / "summary.json"));
    return summary["drilled"]["removed"][0]["mm3"].get<double>();
  };
  const double bySphere = removed("sphere");
  const std::filesystem::path file = this->Folder() / "block.scene.json";
  nlohmann::json scene = nlohmann::json::parse(ReadAll(file));
  scene["tool"] = {
      {"shape", "drill"}, {"radius_mm", 1.6}, {"shaft_radius_mm", 0.5}, {"length_mm", 40}};
  std::ofstream(file) << scene;
  // A hole may be wider by the clearance, a tenth of a voxel. The shaft is above it.
  EXPECT_NEAR(removed("drill"), bySphere, 0.1 * bySphere);
}

TEST_F(CliDrill, ShaftNeedsALength)
{
  const CommandRun run =
      RunPalpate({"touch", "ct.nrrd", "--iso", "750", "--tool-shaft", "0.5"}, this->Folder());
  EXPECT_NE(run.Code, 0);
  EXPECT_NE(run.Errors.find("--tool-length"), std::string::npos) << run.Errors;
}

TEST_F(CliDrill, DrilledVolumeIsReportedAndWritten)
{
  const CommandRun run = this->Run({"--drill", "pedal.json", "--output", "felt", "--drilled",
                                    "left.nrrd", "--drilled", "left.stl"});
  ASSERT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("bone: "), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("mm\u00b3 removed"), std::string::npos) << run.Output;
  EXPECT_NE(run.Output.find("nerve: smallest distance "), std::string::npos) << run.Output;
  EXPECT_NE(run.Errors.find("The drill is "), std::string::npos) << run.Errors;
  for (const char* name : {"left.nrrd", "left.stl", "felt/drill.state", "felt/session.touch"})
  {
    EXPECT_TRUE(std::filesystem::exists(this->Folder() / name)) << name;
  }
  const nlohmann::json summary =
      nlohmann::json::parse(ReadAll(this->Folder() / "felt/summary.json"));
  EXPECT_GT(summary["drilled"]["removed"][0]["mm3"].get<double>(), 5.0);
  EXPECT_NE(ReadAll(this->Folder() / "felt/report.html").find("Removed volume"), std::string::npos);
}

TEST_F(CliDrill, ReplayReproducesHolesAndStateContinues)
{
  ASSERT_EQ(this->Run({"--drill", "pedal.json", "--output", "felt"}).Code, 0);
  const CommandRun again = RunPalpate(
      {"touch", "felt/scene.json", "--replay", "felt/session.touch", "--output", "again"},
      this->Folder());
  EXPECT_EQ(again.Code, 0) << again.Output << again.Errors;
  EXPECT_EQ(again.Output.rfind("0 of 5000 ", 0), 0U) << again.Output;
  EXPECT_EQ(ReadAll(this->Folder() / "again/drill.state"),
            ReadAll(this->Folder() / "felt/drill.state"));
  const CommandRun later = this->Run({"--drill-state", "felt/drill.state", "--output", "later"});
  ASSERT_EQ(later.Code, 0) << later.Errors;
  EXPECT_EQ(ReadAll(this->Folder() / "later/drill.state"),
            ReadAll(this->Folder() / "felt/drill.state"));
}

TEST_F(CliDrill, OptionsDrillImageWithoutScene)
{
  const CommandRun run =
      RunPalpate({"touch", "ct.nrrd", "--iso", "750", "--wear", "0.5", "--tool-radius", "1.6",
                  "--scale", "1", "--path", "hand.csv", "--drill", "pedal.json"},
                 this->Folder());
  EXPECT_EQ(run.Code, 0) << run.Errors;
  EXPECT_NE(run.Output.find("removed"), std::string::npos) << run.Output;
}

TEST_F(CliDrill, RejectsInvalidRequestsWithOneMessage)
{
  EXPECT_EQ(this->Run({"--drill", "hand.csv"}).Code, 2);
  EXPECT_EQ(this->Run({"--drill", "none.json"}).Code, 2);
  EXPECT_EQ(this->Run({"--drill-state", "hand.csv"}).Code, 2);
  const CommandRun ending = this->Run({"--drilled", "left.txt"});
  EXPECT_EQ(ending.Code, 2);
  EXPECT_NE(ending.Errors.find("left.txt is neither a volume nor a surface file"),
            std::string::npos)
      << ending.Errors;
  const CommandRun nothing =
      RunPalpate({"touch", "ct.nrrd", "--iso", "750", "--drill", "pedal.json"}, this->Folder());
  EXPECT_EQ(nothing.Code, 2);
  EXPECT_NE(nothing.Errors.find("no structure of the scene is drilled"), std::string::npos);
}

// The tutorial's steps.
TEST(CliDrillMastoid, TutorialDrillingOpensMastoid)
{
  if (!std::filesystem::exists(HeadCtProject))
  {
    GTEST_SKIP() << HeadCtProject << " is not there: install invesalius-examples";
  }
  const TemporaryFolder folder;
  const std::string make = "/usr/bin/python3 " PALPATE_SOURCE_DIR "/Data/make_mastoid.py " +
                           HeadCtProject.string() + " " + (folder / "mastoid").string();
  ASSERT_EQ(std::system(make.c_str()), 0);
  const CommandRun run =
      RunPalpate({"touch", "mastoid/mastoid.scene.json", "--path", "mastoid/hand.csv", "--drill",
                  "mastoid/drill.json", "--output", "felt"},
                 folder.Path());
  ASSERT_EQ(run.Code, 0) << run.Errors;
  const nlohmann::json summary = nlohmann::json::parse(ReadAll(folder / "felt/summary.json"));
  EXPECT_NEAR(summary["drilled"]["removed"][0]["mm3"].get<double>(), 916.0, 20.0);
  EXPECT_EQ(summary["fault"], "");
}
} // namespace
} // namespace palpate::cli_drill_test
