#include "CsvRecords.h"
#include "InputError.h"
#include "MessageOf.h"
#include "TaskCases.h"
#include "TaskPower.h"
#include "TaskResults.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <sstream>

namespace palpate::task_results_test
{
namespace
{
using namespace palpate::test;

std::vector<std::vector<std::string>> CellsOf(const std::string& text)
{
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
  {
    rows.emplace_back();
    std::istringstream cells(line + ",");
    for (std::string cell; std::getline(cells, cell, ',');)
    {
      rows.back().push_back(cell);
    }
  }
  return rows;
}

class TaskResultsTest : public testing::Test
{
protected:
  // Landmarks that are off by `error` mm in the first condition, twice as much in the second.
  void Do(int number, double error, const std::string& level = "") const
  {
    TaskRun run(this->Task, {number, {{"years", "4"}}, level, 0}, this->Folder.Path());
    while (run.State() != TaskState::Finished)
    {
      if (run.State() == TaskState::Paused)
      {
        run.Resume();
      }
      TaskAnswer answer = TargetOf(TaskKind::Landmarks).Right;
      const double factor = 1.0 + static_cast<double>(run.Trial()->Condition);
      // Trials differ a little, as a mixed model needs it.
      const double more = 0.01 * ((run.Trial()->Number * 7 + number * 3) % 5);
      answer.PointsWorld[0].x() += factor * error + more;
      answer.PointsWorld[1].x() += factor * error + more;
      run.Start();
      run.End(answer, {});
    }
  }

  TaskSettings Task = TaskOf(TaskKind::Landmarks);
  TemporaryFolder Folder;
};

TEST_F(TaskResultsTest, TableHasARowATrial)
{
  this->Do(2, 0.5);
  this->Do(1, 0.25);
  const auto rows = CellsOf(TaskResultsCsv(ReadTaskResults(this->Folder.Path())));
  const std::vector<std::string> head{
      "task",          "participant",      "by",        "level",        "trial",        "training",
      "condition",     "condition_before", "target",    "attempt",      "ended_by",     "seconds",
      "force_mean_n",  "force_peak_n",     "touched_s", "depth_max_mm", "tool_path_mm", "success",
      "error_mean_mm", "error_max_mm",     "missing",   "asked_years"};
  ASSERT_EQ(rows.size(), 13U);
  EXPECT_EQ(rows[0], head);
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i].size(), head.size());
    EXPECT_EQ(rows[i][1], i <= 6 ? "1" : "2");
    EXPECT_EQ(rows[i][2], "person");
    EXPECT_EQ(rows[i][4], std::to_string((i - 1) % 6 + 1));
    EXPECT_EQ(rows[i][7], (i - 1) % 6 == 0 ? "" : rows[i - 1][6]);
    EXPECT_EQ(rows[i][21], "4");
  }
}

TEST_F(TaskResultsTest, SimulationsAreMarkedInEveryRow)
{
  this->Do(1, 0.5, "novice");
  const TaskResults results = ReadTaskResults(this->Folder.Path());
  const auto rows = CellsOf(TaskResultsCsv(results));
  for (std::size_t i = 1; i < rows.size(); ++i)
  {
    EXPECT_EQ(rows[i][2], "simulation");
    EXPECT_EQ(rows[i][3], "novice");
  }
  EXPECT_TRUE(Contains(TaskAnalysisScript(results), "SIMULATION"));
}

TEST_F(TaskResultsTest, RefusesFoldersOfDifferentThings)
{
  EXPECT_TRUE(Contains(MessageOf([&] { ReadTaskResults(this->Folder.Path()); }), "no results"));
  EXPECT_TRUE(Contains(MessageOf([&] { ReadTaskResults(this->Folder / "absent"); }), "no results"));
  this->Do(1, 0.5);
  this->Do(2, 0.5, "novice");
  EXPECT_TRUE(Contains(MessageOf([&] { ReadTaskResults(this->Folder.Path()); }), "mixes people"));
  std::filesystem::remove(this->Folder / "participant-0002.jsonl");
  TaskSettings other = this->Task;
  other.Id = "other";
  TaskRun(other, {2, {}, "", 0}, this->Folder.Path());
  EXPECT_TRUE(Contains(MessageOf([&] { ReadTaskResults(this->Folder.Path()); }), "another task"));
}

TEST_F(TaskResultsTest, CountsTrialsThatBeganAgain)
{
  {
    TaskRun run(this->Task, {1, {}, "", 0}, this->Folder.Path());
    run.Start();
  }
  this->Do(1, 0.5);
  const TaskResults results = ReadTaskResults(this->Folder.Path());
  EXPECT_EQ(results.Unfinished, 1);
  EXPECT_EQ(results.Rows[0].End.Attempt, 2);
}

TEST_F(TaskResultsTest, ScriptRunsInR)
{
  if (std::system("Rscript --version >/dev/null 2>&1") != 0) // NOLINT: a fixed text
  {
    GTEST_SKIP() << "R is not there";
  }
  for (int number = 1; number <= 6; ++number)
  {
    this->Do(number, 0.4 + 0.01 * (number * number % 7), "expert");
  }
  const TaskResults results = ReadTaskResults(this->Folder.Path());
  WriteAll(this->Folder / "results.csv", TaskResultsCsv(results));
  std::string script = TaskAnalysisScript(results);
  for (const char* package : {"lme4", "none"}) // with the package, and without
  {
    WriteAll(this->Folder / "analysis.R",
             script.replace(script.find("requireNamespace('") + 18, 4, package));
    const std::string command =
        "cd '" + this->Folder.Path().string() + "' && Rscript --vanilla analysis.R >log 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0); // NOLINT: a folder of this test
    const std::string log = ReadAll(this->Folder / "log");
    EXPECT_TRUE(Contains(log, "SIMULATION"));
    EXPECT_TRUE(Contains(log, "condition"));
    EXPECT_TRUE(Contains(log, "Pr(>")); // a test of the condition
  }
}

TEST_F(TaskResultsTest, ComparesTheConditionsByTheirMeans)
{
  for (int number = 1; number <= 4; ++number)
  {
    this->Do(number, 0.25 * number);
  }
  TaskComparison comparison = CompareConditions(ReadTaskResults(this->Folder.Path()), 100, 1);
  EXPECT_EQ(comparison.First, "force");
  EXPECT_EQ(comparison.Second, "sight");
  EXPECT_EQ(comparison.Participants, 4);
  // 0.25 to 1, at most 0.04 more each.
  EXPECT_NEAR(comparison.FirstMean, 0.625, 0.04);
  EXPECT_NEAR(comparison.Difference, 0.625, 0.04);
  EXPECT_NEAR(comparison.DifferenceDeviation, 0.25 * std::sqrt(5.0 / 3.0), 0.04);
}
} // namespace
} // namespace palpate::task_results_test
