#include "CommandRun.h"
#include "MessageOf.h"
#include "TemporaryFolder.h"

#include <algorithm>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>

namespace palpate::cli_task_test
{
namespace
{
using namespace palpate::test;
using Json = nlohmann::json;

class CliTask : public testing::Test
{
protected:
  CommandRun Run(std::vector<std::string> words, int code = 0) const
  {
    words.insert(words.begin(), "task");
    CommandRun run = RunPalpate(words, this->Folder.Path());
    EXPECT_EQ(run.Code, code) << run.Errors;
    return run;
  }
  // A ready task with one trial of each condition and no training.
  void WriteShortTask(const std::string& kind, const std::vector<std::string>& targets) const
  {
    this->Run({"init", kind, "--output", "study"});
    Json task = Json::parse(ReadAll(this->Folder / "study/task.json"));
    task["trials"] = 1;
    task["training_trials"] = 0;
    Json kept = Json::array();
    for (const Json& target : task["targets"])
    {
      if (std::find(targets.begin(), targets.end(), target["id"]) != targets.end())
      {
        kept.push_back(target);
      }
    }
    task["targets"] = kept;
    WriteAll(this->Folder / "study/task.json", task.dump());
  }

  TemporaryFolder Folder;
};

TEST_F(CliTask, EveryReadyTaskCanBeReadAndPlanned)
{
  for (const std::string kind : {"nodule", "landmarks", "outline", "mask", "dock", "path"})
  {
    this->Run({"init", kind, "--output", kind});
    const Json checked = Json::parse(this->Run({"check", kind + "/task.json", "--json"}).Output);
    EXPECT_EQ(checked.at("kind"), kind);
    EXPECT_EQ(checked.at("conditions"), 2);
    const Json plans = Json::parse(
        this->Run({"plan", kind + "/task.json", "--participants", "3", "--json"}).Output);
    EXPECT_EQ(plans.at("plans").size(), 3U);
    EXPECT_EQ(plans.at("plans").at(0).at("trials").size(), checked.at("trials"));
    // It isn't replaced.
    this->Run({"init", kind, "--output", kind}, 2);
  }
}

// One of 12 mm, of 80 kPa in 20 kPa and 2 mm under the surface, is well above what is noticed.
TEST_F(CliTask, SimulatedExpertFindsANoduleByForce)
{
  this->WriteShortTask("nodule", {"target-1"});
  this->Run({"simulate", "study/task.json", "--participants", "1", "--level", "expert", "--output",
             "simulated"});
  const std::string table = ReadAll(this->Folder / "simulated/results.csv");
  const std::size_t row = table.find(",force,,target-1,1,done,");
  ASSERT_NE(row, std::string::npos) << table;
  // A success that was reported, after ended_by and six numbers.
  std::istringstream cells(table.substr(row + 24));
  std::vector<std::string> values;
  for (std::string cell; values.size() < 8 && std::getline(cells, cell, ',');)
  {
    values.push_back(cell);
  }
  EXPECT_EQ(values[6], "1") << table;
  EXPECT_EQ(values[7], "1") << table;
}

TEST_F(CliTask, EveryOutputOfASimulationSaysSo)
{
  this->WriteShortTask("outline", {"target-1"});
  const CommandRun run =
      this->Run({"simulate", "study/task.json", "--participants", "2", "--output", "simulated"});
  EXPECT_EQ(run.Output.rfind("SIMULATION", 0), 0U);
  EXPECT_TRUE(Contains(ReadAll(this->Folder / "simulated/results.csv"), ",simulation,novice,"));
  EXPECT_TRUE(Contains(ReadAll(this->Folder / "simulated/analysis.R"), "SIMULATION"));
  EXPECT_TRUE(Contains(ReadAll(this->Folder / "simulated/participant-0001.jsonl"),
                       "\"is_simulation\":true"));
  const CommandRun again = this->Run({"results", "simulated", "--output", "elsewhere"});
  EXPECT_EQ(again.Output, run.Output);
  EXPECT_EQ(ReadAll(this->Folder / "elsewhere/results.csv"),
            ReadAll(this->Folder / "simulated/results.csv"));
}

TEST_F(CliTask, RefusesWhatItCannotUse)
{
  WriteAll(this->Folder / "task.json", "{\"format\": \"palpate-task\", \"version\": 1}");
  EXPECT_TRUE(Contains(this->Run({"check", "task.json"}, 2).Errors, "task.json"));
  EXPECT_TRUE(Contains(this->Run({"check", "absent.json"}, 2).Errors, "does not exist"));
  EXPECT_TRUE(Contains(this->Run({"init", "juggle", "--output", "a"}, 2).Errors, "landmarks"));
  EXPECT_TRUE(Contains(this->Run({"init", "path"}, 2).Errors, "--output"));
  EXPECT_TRUE(Contains(this->Run({"results", "."}, 2).Errors, "no results"));
  this->Run({"juggle", "task.json"}, 2);
  this->WriteShortTask("path", {"target-1"});
  std::filesystem::remove(this->Folder / "study/target-1/gland.scene.json");
  EXPECT_TRUE(Contains(this->Run({"check", "study/task.json"}, 2).Errors, "gland.scene.json"));
}
} // namespace
} // namespace palpate::cli_task_test
