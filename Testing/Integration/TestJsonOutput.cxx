// Compares Documentation/JsonOutput.md with every command's --json output.
#include "CommandRun.h"
#include "DrillBlock.h"
#include "ImageWriter.h"
#include "InputError.h"
#include "JsonPaths.h"
#include "LabelImages.h"
#include "SceneFile.h"
#include "StudyMarkups.h"
#include "SyntheticFiles.h"
#include "TemporaryFolder.h"
#include "TouchReport.h"
#include "TradeText.h"

#include <algorithm>
#include <fstream>
#include <gtest/gtest.h>
#include <map>
#include <set>
#include <sstream>
#include <utility>
#include <vector>

namespace palpate::json_output_test
{
namespace
{
using namespace palpate::test;

using Json = nlohmann::json;

// A command's table: key and meaning of each row.
using Table = std::map<std::string, std::string>;

std::string Between(const std::string& text, const std::string& begin, const std::string& end)
{
  const std::size_t first = text.find(begin);
  if (first == std::string::npos)
  {
    return {};
  }
  const std::size_t start = first + begin.size();
  return text.substr(start, text.find(end, start) - start);
}

std::map<std::string, Table> DocumentedTables()
{
  std::map<std::string, Table> tables;
  std::ifstream page(PALPATE_DOCUMENTATION "/JsonOutput.md");
  std::string command;
  for (std::string line; std::getline(page, line);)
  {
    if (line.rfind("## ", 0) == 0)
    {
      command = Between(line, "`palpate ", "`");
      tables[command].emplace("schema_version", "of every object");
    }
    else if (line.rfind("| `", 0) == 0)
    {
      const std::string keys = line.substr(0, line.find(" | "));
      const std::string meaning = Between(line, "` | ", " |");
      std::size_t end = 0;
      for (std::size_t at = keys.find('`'); at != std::string::npos; at = keys.find('`', end + 1))
      {
        end = keys.find('`', at + 1);
        const std::string key = keys.substr(at + 1, end - at - 1);
        EXPECT_TRUE(tables[command].emplace(key, meaning).second)
            << command << " has two rows for " << key;
      }
    }
  }
  return tables;
}

// An empty list is valid for any documented list.
bool IsDocumented(const std::string& path, const Table& table)
{
  const auto next = table.lower_bound(path);
  const bool isList = path.size() > 2 && path.compare(path.size() - 2, 2, "[]") == 0;
  return next != table.end() &&
         (next->first == path || (isList && next->first.rfind(path, 0) == 0));
}

class JsonOutput : public testing::Test
{
protected:
  JsonOutput()
  {
    WriteTwoSpheres(this->Folder / "a.nii.gz");
    WriteNearlyASphere(this->Folder / "ball.json");
    WriteAll(this->Folder / "bad.nii.gz", "no image");
  }

  void Run(const std::vector<std::string>& arguments)
  {
    const CommandRun run = RunPalpate(arguments, this->Folder.Path());
    ASSERT_FALSE(run.Output.empty()) << run.Errors;
    this->Take(run.Output);
  }

  // One object, or one per line.
  void Take(const std::string& text)
  {
    const Json whole = Json::parse(text, nullptr, false);
    if (!whole.is_discarded())
    {
      return this->Add(whole);
    }
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
    {
      this->Add(Json::parse(line));
    }
  }

  void ExpectDocumented(const std::string& command)
  {
    const std::map<std::string, Table> tables = DocumentedTables();
    ASSERT_EQ(tables.count(command), 1U) << command;
    const Table& table = tables.at(command);
    for (const std::string& path : this->Paths)
    {
      EXPECT_TRUE(IsDocumented(path, table))
          << command << " prints " << path << ", not on the page";
    }
    for (const auto& [key, meaning] : table)
    {
      EXPECT_EQ(this->Paths.count(key), 1U) << command << " never printed " << key;
    }
  }

  TemporaryFolder Folder;

private:
  void Add(const Json& object)
  {
    EXPECT_EQ(object.value("schema_version", 0), 4) << object;
    AddJsonPaths(object, "", this->Paths);
  }

  std::set<std::string> Paths;
};

TEST_F(JsonOutput, FitIsDocumented)
{
  // Refused for its degree, not read, fitted with files.
  this->Run({"fit", "a.nii.gz", "--degree", "0", "--min-dice", "1", "--json"});
  this->Run({"fit", "bad.nii.gz", "--json"});
  this->Run({"fit", "a.nii.gz", "--degree", "4", "--output", "out", "--json"});
  WriteTorus(this->Folder / "torus.nii.gz"); // a surface model with a repair
  this->Run({"fit", "torus.nii.gz", "--degree", "4", "--min-dice", "0", "--json"});
  // A search that ends without what it was for.
  this->Run({"fit", "torus.nii.gz", "--degree", "auto", "--max-degree", "5", "--min-dice", "0",
             "--json"});
  // As surfaces, and from a surface file.
  this->Run({"fit", "a.nii.gz", "--degree", "4", "--model", "surface", "--json"});
  this->Run({"fit", "out/a_1/surface.vtp", "--degree", "4", "--json"});
  this->ExpectDocumented("fit");
}

TEST_F(JsonOutput, SoftenIsDocumented)
{
  this->Run({"soften", "ball.json", "--output", "soft.json", "--elements", "4", "--degree", "4",
             "--map-degree", "6", "--free", "posterior", "--neighbour", "a.nii.gz", "--lesion",
             "a.nii.gz", "--lesion-modulus", "60", "--json"});
  this->ExpectDocumented("soften");
}

TEST_F(JsonOutput, InfoIsDocumented)
{
  this->Run({"info", "a.nii.gz", "bad.nii.gz", "--json"});
  this->ExpectDocumented("info");
}

TEST_F(JsonOutput, MeshIsDocumented)
{
  this->Run({"mesh", "a.nii.gz", "--label", "1,7", "--output", "out", "--json"});
  this->ExpectDocumented("mesh");
}

TEST_F(JsonOutput, CompareIsDocumented)
{
  this->Run({"compare", "ball.json", "a.nii.gz", "--label", "1", "--output", "compared", "--json",
             "--mirror", "--landmark", "1,2,3"});
  this->ExpectDocumented("compare");
}

TEST_F(JsonOutput, RegisterIsDocumented)
{
  StudyMarkups markups;
  markups.Landmarks = {{"a", {0, 0, 0}}, {"b", {10, 0, 0}}, {"c", {0, 10, 0}}};
  WriteMarkups(this->Folder / "a.mrk.json", markups);
  this->Run({"register", "ball.json", "ball.json", "--moving-landmarks", "a.mrk.json",
             "--fixed-landmarks", "a.mrk.json", "--output", "a.tfm", "--json"});
  this->Run({"register", "a.nii.gz", "a.nii.gz", "--images", "--json"});
  this->ExpectDocumented("register");
}

TEST_F(JsonOutput, CompleteIsDocumented)
{
  WriteAll(this->Folder / "a.csv", "x,y,z\n9,0,0\n-9,0,0\n0,9,0\n0,-9,0\n0,0,9\n0,0,-9\n");
  this->Run({"complete", "a.csv", "--output", "completed", "--json"});
  this->ExpectDocumented("complete");
}

TEST_F(JsonOutput, MeasureIsDocumented)
{
  this->Run({"measure", "ball.json", "--from", "9,0,0", "--to", "0,9,0", "--path", "p.vtp", "--map",
             "m.vtp", "--json"});
  this->ExpectDocumented("measure");
}

TEST_F(JsonOutput, CorrectIsDocumented)
{
  this->Run({"correct", "a.nii.gz", "--label", "1", "--pull", "9,0,0:2:4+8", "--pull",
             "-9,0,0:-11,0,0", "--islands", "--fill", "--smooth", "1", "--cut", "0,0,7:0,0,1",
             "--output", "corrected", "--json"});
  WriteAll(this->Folder / "painted.json",
           R"({"format": "palpate-corrections", "version": 1, "steps": [
             {"do": "paint", "path_mm": [0, 0, 0, 3, 0, 0], "radius_mm": 2, "slice_normal": [0, 0, 1]},
             {"do": "erase", "path_mm": [0, 0, 0], "radius_mm": 2},
             {"do": "add_voxels", "runs": [1, 1, 1, 2]},
             {"do": "remove_voxels", "runs": [1, 1, 1, 2]},
             {"do": "copy_slice", "axis": 2, "slices": [9, 12]},
             {"do": "fill_between", "axis": 2, "slices": [9, 12]}]})");
  this->Run({"correct", "a.nii.gz", "--label", "1", "--steps", "painted.json", "--json"});
  this->Run({"correct", "ball.json", "--pull", "9,0,0:2", "--json"});
  this->ExpectDocumented("correct");
}

TEST_F(JsonOutput, RelateIsDocumented)
{
  WriteImage(this->Folder / "tube.nii.gz",
             MakeLabelImage({}, [](double x, double y, double)
                            { return std::hypot(x - 10.0, y - 10.0) < 2.0; }));
  this->Run({"relate", "ball.json", "a.nii.gz", "tube.nii.gz", "bad.nii.gz", "--calibre",
             "--output", "related", "--json"});
  this->ExpectDocumented("relate");
}

TEST_F(JsonOutput, CheckIsDocumented)
{
  this->Run({"check", "a.nii.gz", "bad.nii.gz", "--output", "checked", "--json"});
  this->ExpectDocumented("check");
}

TEST_F(JsonOutput, EvaluateIsDocumented)
{
  this->Run({"evaluate", "ball.json", "--direction", "1,0,0", "--point", "1,2,3", "--json"});
  ASSERT_EQ(RunPalpate({"convert", "ball.json", "ball.coef"}, this->Folder.Path()).Code, 0);
  this->Run({"evaluate", "ball.coef", "--point", "1,2,3", "--json"});
  this->ExpectDocumented("evaluate");
}

TEST_F(JsonOutput, StudyIsDocumented)
{
  WriteAll(this->Folder / "case.palpate.json",
           R"({"format": "palpate-study", "fit": {"frequency": 10}, "dial": "automatic",
               "segmentation": "a.nii.gz", "structures": [{"label": 1, "degree": 4}]})");
  this->Run({"study", "case.palpate.json", "--json"});
  this->ExpectDocumented("study");
}

TEST_F(JsonOutput, SceneIsDocumented)
{
  WriteAll(this->Folder / "a.scene.json",
           R"({"format": "palpate-scene", "structures": [{"file": "ball.json"},
               {"file": "a.nii.gz", "label": 1, "seen": false, "touched": false}]})");
  this->Run({"scene", "explain", "a.scene.json", "--json"});
  // Without touch there is no servo scene.
  WriteAll(
      this->Folder / "seen.scene.json",
      R"({"format": "palpate-scene", "structures": [{"file": "ball.json", "touched": false}]})");
  this->Run({"scene", "explain", "seen.scene.json", "--json"});
  this->ExpectDocumented("scene");
}

TEST_F(JsonOutput, TaskIsDocumented)
{
  this->Run({"task", "init", "path", "--output", "study", "--json"});
  this->Run({"task", "plan", "study/task.json", "--participants", "1", "--json"});
  this->Run({"task", "simulate", "study/task.json", "--participants", "2", "--output", "simulated",
             "--json"});
  this->ExpectDocumented("task");
}

TEST_F(JsonOutput, TouchIsDocumented)
{
  const DrillBlock block;
  WriteAll(this->Folder / "block.scene.json",
           palpate::SceneText(block.Settings(true), this->Folder.Path()));
  WriteAll(this->Folder / "hand.csv",
           "time_s,x_mm,y_mm,z_mm\n0,0,0,8\n1,0,0,5.8\n4,0,0,0\n5,0,0,8\n");
  WriteAll(this->Folder / "pedal.json", R"({"format": "palpate-drill",
    "actions": [{"time_s": 0.5, "do": "start"}, {"time_s": 4.5, "do": "stop"}]})");
  this->Run({"touch", "block.scene.json", "--path", "hand.csv", "--drill", "pedal.json", "--output",
             "felt", "--json"});
  this->Run({"touch", "felt/scene.json", "--replay", "felt/session.touch", "--json"});
  palpate::TouchResult realTime;
  realTime.Periods.Add(1000);
  this->Take(palpate::TouchSummaryText({}, realTime));
  this->ExpectDocumented("touch");
}

TEST_F(JsonOutput, TradeoffIsDocumented)
{
  this->Run({"tradeoff", "ball.json", "--seconds", "0.5", "--runs", "1", "--json"});
  palpate::TradeResult result;
  palpate::TradeRow refused;
  refused.State = palpate::TradeRow::Outcome::Refused;
  result.Structures.push_back({"gland", {refused}, {}});
  this->Take(palpate::TradeJson(result));
  this->ExpectDocumented("tradeoff");
}

TEST_F(JsonOutput, DevicesAreDocumented)
{
  this->Run({"devices", "--json"});
  this->Run({"devices", "--home", "--device", "simulated", "--json"});
  this->ExpectDocumented("devices");
}

TEST(JsonPage, HasTableForEveryJsonCommand)
{
  const TemporaryFolder folder;
  const CommandRun help = RunPalpate({"--help"}, folder.Path());
  const std::map<std::string, Table> tables = DocumentedTables();
  std::istringstream lines(help.Output.substr(help.Output.find("Subcommands:")));
  std::size_t found = 0;
  for (std::string line; std::getline(lines, line);)
  {
    const std::string command = Between(line, "  ", " ");
    if (command.empty() || line.rfind("  ", 0) != 0 || line[2] == ' ' || command == "palpate")
    {
      continue;
    }
    const std::string options = RunPalpate({command, "--help"}, folder.Path()).Output;
    const bool hasJson = options.find("  --json") != std::string::npos;
    EXPECT_EQ(tables.count(command), hasJson ? 1U : 0U) << command;
    found += hasJson ? 1 : 0;
  }
  EXPECT_EQ(found, tables.size());
}

// Whether a key, or an object around it, ends so.
bool EndsSomewhere(const std::string& key, const std::string& end)
{
  const std::size_t found = key.find(end);
  return found != std::string::npos &&
         (found + end.size() == key.size() || key.find_first_of(".[", found) == found + end.size());
}

// The page lists the ends of keys that give units once; each is of some key.
TEST(JsonPage, ListsUnitSuffixesOfKeys)
{
  const std::vector<std::pair<std::string, std::string>> units{{"_kpa_per_mm", "kPa/mm"},
                                                               {"_kpa", "kPa"},
                                                               {"_n_per_mm", "N/mm"},
                                                               {"_mm_per_rad", "mm/rad"},
                                                               {"_n_mm", "N mm"},
                                                               {"_mm2", "mm\u00b2"},
                                                               {"mm3", "mm\u00b3"},
                                                               {"_mm", "mm"},
                                                               {"_ml", "ml"},
                                                               {"_percent", "%"},
                                                               {"seconds", "s"},
                                                               {"_s", "s"},
                                                               {"_us", "\u00b5s"},
                                                               {"_ms", "ms"},
                                                               {"_ns", "ns"},
                                                               {"_hz", "Hz"},
                                                               {"_n", "N"},
                                                               {"_mb", "MiB"},
                                                               {"bytes", "bytes"},
                                                               {"_degrees", "degrees"},
                                                               {"_jnd", "JND"}};
  std::ifstream page(PALPATE_DOCUMENTATION "/JsonOutput.md");
  std::stringstream text;
  text << page.rdbuf();
  std::string listed = Between(text.str(), "ends in the unit: ", ".\n");
  std::replace(listed.begin(), listed.end(), '\n', ' ');
  EXPECT_EQ(std::count(listed.begin(), listed.end(), ',') + 1, std::ptrdiff_t(units.size()));
  std::set<std::string> keys;
  for (const auto& [command, table] : DocumentedTables())
  {
    for (const auto& [key, meaning] : table)
    {
      EXPECT_FALSE(meaning.empty()) << command << ": " << key;
      keys.insert(key);
    }
  }
  for (const auto& [end, unit] : units)
  {
    EXPECT_NE((listed + ",").find("`" + end + "` " + unit + ","), std::string::npos) << end;
    EXPECT_TRUE(std::any_of(keys.begin(), keys.end(),
                            [&end = end](const std::string& key)
                            { return EndsSomewhere(key, end); }))
        << end;
  }
}
} // namespace
} // namespace palpate::json_output_test
