#include "TaskResults.h"

#include "CsvCell.h"
#include "DecimalText.h"
#include "OutputFolder.h"
#include "Refusal.h"
#include "TaskLog.h"
#include "WholeFile.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <system_error>

namespace palpate
{
namespace
{
std::vector<std::filesystem::path> LogsIn(const std::filesystem::path& folder)
{
  constexpr std::size_t NameLength = 22; // participant-0001.jsonl
  std::vector<std::filesystem::path> logs;
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error))
  {
    const std::string name = entry->path().filename().string();
    if (name.size() == NameLength && name.rfind("participant-", 0) == 0 &&
        entry->path().extension() == ".jsonl")
    {
      logs.push_back(entry->path());
    }
  }
  std::sort(logs.begin(), logs.end());
  if (logs.empty())
  {
    Refuse(folder, "has no results of a task (participant-0001.jsonl)",
           "name the folder that a task was run or simulated into");
  }
  return logs;
}

void RequireAlike(const TaskResults& results, const TaskBeginning& beginning,
                  const std::filesystem::path& log)
{
  if (results.Participants.empty())
  {
    return;
  }
  if (beginning.TaskId != results.TaskId || beginning.Kind != results.Kind ||
      beginning.Conditions != results.Conditions)
  {
    Refuse(log, "is of another task than the other logs of its folder",
           "keep each task in a folder of its own");
  }
  if (beginning.Participant.SimulatedLevel.empty() == results.IsSimulation)
  {
    Refuse(log, "mixes people and simulated hands in one folder",
           "keep simulations in a folder of their own");
  }
}

void AddLog(TaskResults& results, const std::filesystem::path& log)
{
  const std::vector<std::string> lines = TaskLog::ReadLines(log);
  if (lines.empty())
  {
    return; // cut off at its beginning
  }
  const TaskBeginning beginning = ReadTaskBeginning(lines.front(), log);
  RequireAlike(results, beginning, log);
  results.TaskId = beginning.TaskId;
  results.Kind = beginning.Kind;
  results.Conditions = beginning.Conditions;
  results.IsSimulation = !beginning.Participant.SimulatedLevel.empty();
  results.Participants.push_back(beginning.Participant);
  std::string before;
  int begun = 0;
  for (std::size_t i = 1; i < lines.size(); ++i)
  {
    const TaskEvent event = ReadTaskEvent(lines[i], log, i + 1, beginning.Kind);
    begun += event.Is == TaskEvent::Kind::Start ? 1 : 0;
    if (event.Is != TaskEvent::Kind::End)
    {
      continue;
    }
    const auto& known = beginning.Conditions;
    if (event.Score.Values.size() != TaskMeasures(beginning.Kind).size() ||
        std::find(known.begin(), known.end(), event.Condition) == known.end())
    {
      Refuse(log, "has no whole result in line " + std::to_string(i + 1),
             "restore the file, or leave it out");
    }
    results.Rows.push_back({results.Participants.size() - 1, event, before});
    before = event.Condition;
    --begun;
  }
  results.Unfinished += begun;
}

std::string NumberCell(double value)
{
  return std::isfinite(value) ? ExactText(value) : "";
}

std::set<std::string> AskedKeys(const TaskResults& results)
{
  std::set<std::string> keys;
  for (const TaskParticipant& one : results.Participants)
  {
    for (const auto& [key, answer] : one.Answers)
    {
      keys.insert(key);
    }
  }
  return keys;
}

// Ids are letters, digits, - and _; so are answers.
std::vector<std::string> CellsOf(const TaskResults& results, const TaskResult& row,
                                 const std::set<std::string>& asked)
{
  const TaskParticipant& who = results.Participants[row.Participant];
  const TaskEvent& end = row.End;
  std::vector<std::string> cells{InertCell(results.TaskId),
                                 std::to_string(who.Number),
                                 results.IsSimulation ? "simulation" : "person",
                                 InertCell(who.SimulatedLevel),
                                 std::to_string(end.Trial),
                                 end.IsTraining ? "1" : "0",
                                 InertCell(end.Condition),
                                 InertCell(row.Before),
                                 InertCell(end.Target),
                                 std::to_string(end.Attempt),
                                 NameOf(end.Conduct.End)};
  for (const double value : {end.Conduct.Seconds, end.Conduct.MeanForce, end.Conduct.PeakForce,
                             end.Conduct.TouchedSeconds, end.Conduct.DeepestMillimeters,
                             end.Conduct.PathMillimeters, end.Score.IsSuccess ? 1.0 : 0.0})
  {
    cells.push_back(NumberCell(value));
  }
  for (const double value : end.Score.Values)
  {
    cells.push_back(NumberCell(value));
  }
  for (const std::string& key : asked)
  {
    const auto answer = who.Answers.find(key);
    cells.push_back(answer == who.Answers.end() ? "" : InertCell(answer->second));
  }
  return cells;
}

std::string LineOf(const std::vector<std::string>& cells)
{
  std::string line;
  for (const std::string& cell : cells)
  {
    line += (line.empty() ? "" : ",") + cell;
  }
  return line + "\n";
}
} // namespace

TaskResults ReadTaskResults(const std::filesystem::path& folder)
{
  TaskResults results;
  for (const std::filesystem::path& log : LogsIn(folder))
  {
    AddLog(results, log);
  }
  if (results.Rows.empty())
  {
    Refuse(folder, "has no trials that ended", "run or simulate the task first");
  }
  return results;
}

double ValueOf(const TaskResult& row, TaskKind kind, const std::string& measure)
{
  const auto& names = TaskMeasures(kind);
  const auto found = std::find(names.begin(), names.end(), measure);
  return found == names.end()
             ? (row.End.Score.IsSuccess ? 1.0 : 0.0)
             : row.End.Score.Values[static_cast<std::size_t>(found - names.begin())];
}

std::string TaskResultsCsv(const TaskResults& results)
{
  std::vector<std::string> head{
      "task",         "participant",      "by",        "level",        "trial",        "training",
      "condition",    "condition_before", "target",    "attempt",      "ended_by",     "seconds",
      "force_mean_n", "force_peak_n",     "touched_s", "depth_max_mm", "tool_path_mm", "success"};
  const auto& measures = TaskMeasures(results.Kind);
  head.insert(head.end(), measures.begin(), measures.end());
  const std::set<std::string> asked = AskedKeys(results);
  for (const std::string& key : asked)
  {
    head.push_back("asked_" + key);
  }
  std::string text = LineOf(head);
  for (const TaskResult& row : results.Rows)
  {
    text += LineOf(CellsOf(results, row, asked));
  }
  return text;
}

std::string TaskAnalysisScript(const TaskResults& results)
{
  std::string conditions;
  for (const std::string& condition : results.Conditions)
  {
    conditions += (conditions.empty() ? "'" : ", '") + condition + "'";
  }
  const std::string label =
      results.IsSimulation ? "SIMULATION: no person took part in these trials.\\n" : "";
  return "# Compares the conditions of the task " + results.TaskId + " by " +
         PrimaryMeasure(results.Kind) +
         ". Run it beside results.csv: Rscript analysis.R\n"
         "d <- read.csv('results.csv', stringsAsFactors = FALSE)\n"
         "d <- d[d$training == 0, ]\n"
         "d$y <- d$" +
         PrimaryMeasure(results.Kind) +
         "\n"
         "d <- d[!is.na(d$y), ]\n"
         "d$condition <- factor(d$condition, levels = c(" +
         conditions +
         "))\n"
         "d$participant <- factor(d$participant)\n"
         "d$target <- factor(d$target)\n"
         "cat('" +
         label +
         "')\n"
         "print(aggregate(y ~ condition, d, function(y) c(mean = mean(y), sd = sd(y), n = "
         "length(y))))\n"
         "if (nlevels(d$condition) < 2) quit(status = 0)\n"
         "if (requireNamespace('lme4', quietly = TRUE)) {\n"
         "  random <- if (nlevels(d$target) > 1) '(1 | participant) + (1 | target)' else "
         "'(1 | participant)'\n"
         "  with <- lme4::lmer(as.formula(paste('y ~ condition + trial +', random)), d, REML = "
         "FALSE)\n"
         "  without <- lme4::lmer(as.formula(paste('y ~ trial +', random)), d, REML = FALSE)\n"
         "  print(summary(with))\n"
         "  print(anova(without, with))\n"
         "} else {\n"
         "  m <- aggregate(y ~ condition + participant, d, mean)\n"
         "  print(summary(aov(y ~ condition + Error(participant / condition), m)))\n"
         "}\n";
}

void WriteTaskResults(const TaskResults& results, const std::filesystem::path& folder)
{
  WriteOutputSet(folder,
                 [&](const std::filesystem::path& stage)
                 {
                   WriteWholeFile(stage / "results.csv", TaskResultsCsv(results));
                   WriteWholeFile(stage / "analysis.R", TaskAnalysisScript(results));
                 });
}
} // namespace palpate
