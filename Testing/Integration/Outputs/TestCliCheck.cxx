#include "CommandRun.h"
#include "ImageWriter.h"
#include "LabelImages.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"

#include <cmath>
#include <fstream>
#include <functional>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>

namespace palpate::cli_check_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

class CliCheck : public testing::Test
{
protected:
  // Ellipsoids of random semi-axes in two labels beside each other, one case a file.
  void WriteCases(const std::string& folder, int count, unsigned seed,
                  const std::function<bool(double, double, double)>& isOut = {}) const
  {
    std::filesystem::create_directory(this->Folder / folder);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (int n = 0; n < count; ++n)
    {
      const double a = 9.0 + 0.7 * normal(random);
      const double b = 8.0 + 0.7 * normal(random);
      const double c = 8.5 + 0.7 * normal(random);
      LabelGrid grid;
      grid.Size = {{30, 28, 28}};
      WriteImage(this->Folder / (folder + "/case" + std::to_string(100 + n) + ".nii.gz"),
                 MakeLabelImage(grid,
                                [&](double x, double y, double z)
                                {
                                  return std::hypot((x - 14) / a, (y - 13) / b, (z - 13) / c) <
                                             1.0 &&
                                         !(isOut && isOut(x, y, z));
                                }));
    }
  }
  CommandRun Run(std::vector<std::string> words) const
  {
    words.insert(words.begin(), "check");
    return RunPalpate(words, this->Folder.Path());
  }
  Json Check(std::vector<std::string> words, int code = 0) const
  {
    words.emplace_back("--json");
    const CommandRun run = this->Run(words);
    EXPECT_EQ(run.Code, code) << run.Errors;
    return run.Output.empty() ? Json() : Json::parse(run.Output);
  }
  std::string TextOf(const std::string& file) const
  {
    std::ifstream stream(this->Folder / file);
    std::stringstream text;
    text << stream.rdbuf();
    return text.str();
  }

  TemporaryFolder Folder;
};

bool IsInHole(double x, double y, double z)
{
  return std::hypot(x - 16, y - 13, z - 13) < 3.5;
}

TEST_F(CliCheck, HoleIsImplausibleByLimitsAndHasItsPlace)
{
  this->WriteCases("bad", 1, 1, IsInHole);
  const Json found = this->Check({"bad/case100.nii.gz"});
  EXPECT_EQ(found.at("by"), "limits");
  const Json organ = found.at("cases")[0].at("structures")[0];
  EXPECT_EQ(organ.at("verdict"), "implausible");
  EXPECT_EQ(organ.at("rule"), "hole");
  EXPECT_NE(organ.at("sentence").get<std::string>().find("has a hole of"), std::string::npos);
  const Json place = organ.at("place_mm");
  EXPECT_NEAR(place[0], 16.0, 0.5);
  EXPECT_NEAR(place[2], 13.0, 0.5);
}

TEST_F(CliCheck, StrictFailsForWhatIsImplausibleOnly)
{
  this->WriteCases("good", 1, 2);
  this->WriteCases("bad", 1, 1, IsInHole);
  EXPECT_EQ(this->Run({"bad/case100.nii.gz"}).Code, 0);
  EXPECT_EQ(this->Run({"bad/case100.nii.gz", "--strict"}).Code, 1);
  EXPECT_EQ(this->Run({"good/case100.nii.gz", "--strict"}).Code, 0);
}

TEST_F(CliCheck, WorstCaseComesFirstAndBrokenFilesLast)
{
  this->WriteCases("cases", 3, 3);
  this->WriteCases("bad", 1, 1, IsInHole);
  std::filesystem::copy_file(this->Folder / "bad/case100.nii.gz",
                             this->Folder / "cases/case200.nii.gz");
  std::ofstream(this->Folder / "cases/case000.nii.gz") << "broken";
  const CommandRun run = this->Run({"cases", "--as", "cases", "--json", "--output", "out"});
  EXPECT_EQ(run.Code, 1);
  EXPECT_NE(run.Errors.find("case000"), std::string::npos);
  const Json cases = Json::parse(run.Output).at("cases");
  ASSERT_EQ(cases.size(), 5U);
  EXPECT_NE(cases[0].at("file").get<std::string>().find("case200"), std::string::npos);
  EXPECT_TRUE(cases[4].at("verdict").is_null());
  EXPECT_NE(cases[4].at("message"), "");
  const std::string page = this->TextOf("out/report.html");
  EXPECT_NE(page.find("<circle"), std::string::npos);
  EXPECT_NE(page.find("implausible"), std::string::npos);
  EXPECT_NE(this->TextOf("out/structures.csv").find("not checked"), std::string::npos);
  EXPECT_EQ(Json::parse(this->TextOf("out/check.json")).at("cases").size(), 5U);
}

TEST_F(CliCheck, GroupIsWrittenReadAndNamesNobody)
{
  this->WriteCases("clean", 30, 4);
  const CommandRun made = this->Run({"clean", "--as", "cases", "--make-group", "group.json"});
  ASSERT_EQ(made.Code, 0) << made.Errors;
  EXPECT_EQ(this->TextOf("group.json").find("case1"), std::string::npos);
  this->WriteCases("bad", 1, 1, IsInHole);
  this->WriteCases("good", 1, 5);
  const Json found =
      this->Check({"bad/case100.nii.gz", "good/case100.nii.gz", "--group", "group.json"});
  EXPECT_EQ(found.at("by"), "group");
  const Json worst = found.at("cases")[0].at("structures")[0];
  EXPECT_EQ(worst.at("verdict"), "implausible");
  EXPECT_EQ(worst.at("by"), "group");
  EXPECT_NEAR(worst.at("p_case"), 1.0 / 31.0, 1e-12);
  EXPECT_EQ(found.at("cases")[1].at("verdict"), "plausible");
}

TEST_F(CliCheck, GroupTooSmallForItsRateFallsBackToLimits)
{
  this->WriteCases("clean", 22, 6);
  ASSERT_EQ(this->Run({"clean", "--as", "cases", "--make-group", "group.json"}).Code, 0);
  const CommandRun run =
      this->Run({"clean/case100.nii.gz", "--group", "group.json", "--false-alarms", "2", "--json"});
  EXPECT_EQ(run.Code, 0);
  EXPECT_NE(run.Errors.find("too few"), std::string::npos);
  EXPECT_EQ(Json::parse(run.Output).at("by"), "limits");
}

TEST_F(CliCheck, RefusesFewCasesAndMalformedGroups)
{
  this->WriteCases("clean", 3, 7);
  const CommandRun few = this->Run({"clean", "--as", "cases", "--make-group", "group.json"});
  EXPECT_EQ(few.Code, 2);
  EXPECT_NE(few.Errors.find("needs 20"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(this->Folder / "group.json"));
  for (
      const char* text :
      {"", "{}", "[1]", R"({"format": "palpate check group", "version": 2})",
       R"({"format": "palpate check group", "version": 1, "scores": [1, 0], "structures": []})",
       R"({"format": "palpate check group", "version": 1, "scores": ["a"], "structures": []})",
       R"({"format": "palpate check group", "version": 1, "scores": [], "structures": [{"name": "a"}]})",
       R"({"format": 3})"})
  {
    std::ofstream(this->Folder / "bad.json") << text;
    const CommandRun run = this->Run({"clean/case100.nii.gz", "--group", "bad.json"});
    EXPECT_EQ(run.Code, 2) << text;
    EXPECT_NE(run.Errors.find("bad.json"), std::string::npos) << run.Errors;
  }
}

TEST_F(CliCheck, FoldersOfMasksAreOneCaseEach)
{
  for (const char* patient : {"p1", "p2"})
  {
    std::filesystem::create_directories(this->Folder / "patients" / patient);
    for (const auto& [name, middle] :
         std::map<std::string, double>{{"kidney_left", 12.0}, {"kidney_right", 40.0}})
    {
      LabelGrid grid;
      grid.Size = {{56, 20, 20}};
      WriteImage(this->Folder / "patients" / patient / (name + ".nii.gz"),
                 MakeLabelImage(grid, [middle = middle](double x, double y, double z)
                                { return std::hypot(x - middle, y - 9.5, z - 9.5) < 7.0; }));
    }
  }
  const Json found = this->Check({"patients"});
  ASSERT_EQ(found.at("cases").size(), 2U);
  EXPECT_EQ(found.at("cases")[0].at("structures").size(), 2U);
  EXPECT_EQ(this->Check({"patients/p1"}).at("cases").size(), 1U);
}

// A ball with a cube of the other one's that lies at its far end, or alone.
TEST_F(CliCheck, IslandNamesWhatItLiesAgainst)
{
  const auto write = [this](const std::string& file, double island)
  {
    LabelGrid grid;
    grid.Size = {{60, 24, 24}};
    const auto labels = MakeLabelImage(grid, [](double x, double y, double z)
                                       { return std::hypot(x - 11, y - 11, z - 11) < 8; });
    const auto others = MakeLabelImage(grid, [](double x, double y, double z)
                                       { return std::hypot(x - 38, y - 11, z - 11) < 8; });
    for (vtkIdType voxel = 0; voxel < labels->GetNumberOfPoints(); ++voxel)
    {
      double at[3];
      labels->GetPoint(voxel, at);
      auto* value = static_cast<unsigned char*>(labels->GetScalarPointer()) + voxel;
      const bool isIsland = std::abs(at[0] - island) < 3 && std::hypot(at[1] - 11, at[2] - 11) < 3;
      const bool isOther = static_cast<unsigned char*>(others->GetScalarPointer())[voxel] != 0;
      *value = isIsland ? 1 : isOther ? 2 : *value;
    }
    WriteImage(this->Folder / file, labels);
  };
  write("against.nii.gz", 45.0);
  write("apart.nii.gz", 56.0);
  const auto sentence = [this](const std::string& file)
  {
    const Json organ = this->Check({file}).at("cases")[0].at("structures")[0];
    EXPECT_EQ(organ.at("rule"), "part");
    return organ.at("sentence").get<std::string>();
  };
  EXPECT_NE(sentence("against.nii.gz").find(", which lies against label 2"), std::string::npos);
  EXPECT_NE(sentence("apart.nii.gz").find(", which touches no other structure"), std::string::npos);
}

TEST_F(CliCheck, RefusedMasksOfAFolderAreNamed)
{
  std::filesystem::create_directory(this->Folder / "masks");
  for (const auto& [name, middle] : std::map<std::string, double>{{"a", 10.0}, {"b", 30.0}})
  {
    LabelGrid grid;
    grid.Size = {{40, 20, 20}};
    WriteImage(this->Folder / "masks" / (name + ".nii.gz"),
               MakeLabelImage(grid, [middle = middle](double x, double y, double z)
                              { return std::hypot(x - middle, y - 9.5, z - 9.5) < 7.0; }));
  }
  std::ofstream(this->Folder / "masks/c.nii.gz") << "broken";
  for (const std::vector<std::string>& as :
       {std::vector<std::string>{}, std::vector<std::string>{"--as", "structures"}})
  {
    std::vector<std::string> words{"masks", "--json", "--output", "out"};
    words.insert(words.end(), as.begin(), as.end());
    const CommandRun run = this->Run(words);
    EXPECT_EQ(run.Code, 1) << run.Errors;
    EXPECT_NE(run.Errors.find("c.nii.gz"), std::string::npos);
    const Json one = Json::parse(run.Output).at("cases")[0];
    EXPECT_EQ(one.at("structures").size(), 2U);
    EXPECT_NE(one.at("notes").dump().find("c.nii.gz"), std::string::npos);
    EXPECT_NE(this->TextOf("out/structures.csv").find("c.nii.gz,not checked"), std::string::npos);
  }
}

TEST_F(CliCheck, OverlappingStructuresAreLookedAt)
{
  std::filesystem::create_directory(this->Folder / "masks");
  for (const auto& [name, middle] : std::map<std::string, double>{{"a", 12.0}, {"b", 21.0}})
  {
    LabelGrid grid;
    grid.Size = {{40, 20, 20}};
    WriteImage(this->Folder / "masks" / (name + ".nii.gz"),
               MakeLabelImage(grid, [middle = middle](double x, double y, double z)
                              { return std::hypot(x - middle, y - 9.5, z - 9.5) < 7.0; }));
  }
  const Json found = this->Check({"masks", "--as", "structures"});
  const Json organ = found.at("cases")[0].at("structures")[0];
  EXPECT_EQ(organ.at("rule"), "overlap");
  EXPECT_NE(organ.at("sentence").get<std::string>().find(" with b ("), std::string::npos);
  // Two balls of 7 mm at 9 mm: the lens is (2 r - d)^2 (d + 4 r) / (16 r^3) of one.
  for (const Json& one : organ.at("statistics"))
  {
    if (one.at("rule") == "overlap")
    {
      EXPECT_NEAR(one.at("value"), 25.0 * 37.0 / (16.0 * 343.0), 0.03);
    }
  }
}
} // namespace
} // namespace palpate::cli_check_test
