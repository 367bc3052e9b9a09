#include "TaskText.h"

#include "DecimalText.h"
#include "JsonSchema.h"
#include "TaskPlan.h"
#include "TextTable.h"

#include <nlohmann/json.hpp>

namespace palpate::cli
{
namespace
{
using JsonObject = nlohmann::ordered_json;

std::string Dumped(const JsonObject& object)
{
  return object.dump(-1, ' ', false, JsonObject::error_handler_t::replace);
}

std::size_t RowCount(const TaskSettings& task)
{
  return WilliamsRows(static_cast<int>(task.Conditions.size())).size();
}

std::size_t TrialCount(const TaskSettings& task)
{
  return task.Conditions.size() * static_cast<std::size_t>(task.Trials + task.TrainingTrials);
}

std::string PowerText(const StudyPower& power)
{
  return FixedText(static_cast<double>(power.Found) / power.Studies, 3) + ", 95 % interval " +
         FixedText(power.Low, 3) + " to " + FixedText(power.High, 3) + " of " +
         std::to_string(power.Studies) + " studies";
}

// Without a meaning for people's results, which would be judged by themselves.
std::string PowersText(const TaskComparison& comparison)
{
  TextTable table;
  table.AlignRight({0});
  for (const StudyPower& power : comparison.Powers)
  {
    table.AddRow({std::to_string(power.Participants), "participants: power " + PowerText(power)});
  }
  const std::string wanted = FixedText(TaskComparison::Wanted, 1);
  return table.Text() +
         (comparison.Sufficient > 0
              ? std::to_string(comparison.Sufficient) + " participants suffice for a power of " +
                    wanted + ", if people were like these simulated hands\n"
              : "no number of these reaches a power of " + wanted + "\n");
}

JsonObject PowersJson(const TaskComparison& comparison)
{
  JsonObject powers = JsonObject::array();
  for (const StudyPower& power : comparison.Powers)
  {
    powers.push_back({{"participants", power.Participants},
                      {"studies", power.Studies},
                      {"found", power.Found},
                      {"low", power.Low},
                      {"high", power.High}});
  }
  return powers;
}
} // namespace

std::string TaskSummaryText(const TaskSettings& task)
{
  const std::string rows = std::to_string(RowCount(task));
  std::string text = task.Id + " (" + NameOf(task.Kind) + "): " + task.Title + "\n";
  text += std::to_string(task.Conditions.size()) + " conditions, " +
          std::to_string(task.Targets.size()) + " targets, " + std::to_string(TrialCount(task)) +
          " trials of a participant\n";
  return text + "orders are balanced for participants in multiples of " + rows + "\n";
}

std::string TaskSummaryJson(const TaskSettings& task)
{
  return Dumped({{JsonSchemaKey, JsonSchemaVersion},
                 {"task", task.Id},
                 {"kind", NameOf(task.Kind)},
                 {"conditions", task.Conditions.size()},
                 {"targets", task.Targets.size()},
                 {"trials", TrialCount(task)},
                 {"balanced_multiple", RowCount(task)}});
}

std::string TaskPlanText(const TaskSettings& task, int participants)
{
  TextTable table;
  table.AlignRight({0, 1});
  for (int participant = 1; participant <= participants; ++participant)
  {
    for (const TaskTrial& trial : PlanOf(task, participant))
    {
      table.AddRow({std::to_string(participant), std::to_string(trial.Number),
                    task.Conditions[trial.Condition].Id, task.Targets[trial.Target].Id,
                    trial.IsTraining ? "training" : "", trial.EndsBlock ? "then a pause" : ""});
    }
  }
  return table.Text();
}

std::string TaskPlanJson(const TaskSettings& task, int participants)
{
  JsonObject plans = JsonObject::array();
  for (int participant = 1; participant <= participants; ++participant)
  {
    JsonObject trials = JsonObject::array();
    for (const TaskTrial& trial : PlanOf(task, participant))
    {
      trials.push_back({{"trial", trial.Number},
                        {"training", trial.IsTraining},
                        {"condition", task.Conditions[trial.Condition].Id},
                        {"target", task.Targets[trial.Target].Id},
                        {"pause_after", trial.EndsBlock}});
    }
    plans.push_back({{"participant", participant}, {"trials", trials}});
  }
  return Dumped({{JsonSchemaKey, JsonSchemaVersion}, {"task", task.Id}, {"plans", plans}});
}

std::string TaskResultsText(const TaskResults& results, const TaskComparison& comparison)
{
  std::string text =
      results.IsSimulation ? "SIMULATION: no person took part in these trials\n" : "";
  text +=
      std::to_string(results.Participants.size()) + " participants, " +
      CountText(static_cast<std::int64_t>(results.Rows.size()), "trial", "trials") +
      (results.Unfinished > 0 ? ", " + std::to_string(results.Unfinished) + " begun again" : "") +
      "\n";
  if (comparison.Participants < 2)
  {
    return text + "no two conditions that two participants did\n";
  }
  text += comparison.Measure + ": " + comparison.First + " " +
          SignificantText(comparison.FirstMean, 3) + ", " + comparison.Second + " " +
          SignificantText(comparison.SecondMean, 3) + "; difference " +
          SignificantText(comparison.Difference, 3) + " +- " +
          SignificantText(comparison.DifferenceDeviation, 3) + " between participants, p " +
          SignificantText(comparison.PValue, 2) + "\n";
  return text + (results.IsSimulation ? PowersText(comparison) : "");
}

std::string TaskResultsJson(const TaskResults& results, const TaskComparison& comparison)
{
  const bool hasTwo = comparison.Participants >= 2;
  return Dumped(
      {{JsonSchemaKey, JsonSchemaVersion},
       {"task", results.TaskId},
       {"simulation", results.IsSimulation},
       {"participants", results.Participants.size()},
       {"trials", results.Rows.size()},
       {"begun_again", results.Unfinished},
       {"measure", comparison.Measure},
       {"first", comparison.First},
       {"second", comparison.Second},
       {"compared", comparison.Participants},
       {"first_mean", hasTwo ? JsonObject(comparison.FirstMean) : JsonObject()},
       {"second_mean", hasTwo ? JsonObject(comparison.SecondMean) : JsonObject()},
       {"difference_sd", hasTwo ? JsonObject(comparison.DifferenceDeviation) : JsonObject()},
       {"p", hasTwo ? JsonObject(comparison.PValue) : JsonObject()},
       {"power", results.IsSimulation ? PowersJson(comparison) : JsonObject::array()},
       {"sufficient", results.IsSimulation && comparison.Sufficient > 0
                          ? JsonObject(comparison.Sufficient)
                          : JsonObject()}});
}
} // namespace palpate::cli
