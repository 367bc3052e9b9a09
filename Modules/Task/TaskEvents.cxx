#include "TaskEvents.h"

#include "JsonFields.h"
#include "JsonNumbers.h"
#include "JsonText.h"
#include "TaskFile.h"

#include <array>
#include <cmath>
#include <limits>
#include <optional>

namespace palpate
{
namespace
{
constexpr const char* LineRemedy = "restore the file, or begin with another folder";
constexpr int LogVersion = 1;
constexpr double LargestMeasure = 1e12;
constexpr std::array<const char*, 4> EndNames{{"done", "time", "force", "given-up"}};

struct TaskReply
{
  std::string Key;
  std::string Value;
};

void ExchangeReply(JsonFields& fields, TaskReply& reply)
{
  fields.Exchange("key", reply.Key);
  fields.Exchange("value", reply.Value);
}

void ExchangeReplies(JsonFields& fields, std::map<std::string, std::string>& answers)
{
  std::vector<TaskReply> replies;
  for (const auto& [key, value] : answers)
  {
    replies.push_back({key, value});
  }
  fields.ExchangeList("answers", replies, ExchangeReply);
  for (const TaskReply& reply : replies)
  {
    answers[reply.Key] = reply.Value;
  }
}

void ExchangeSimulation(JsonFields& fields, TaskParticipant& participant)
{
  bool isSimulated = !participant.SimulatedLevel.empty();
  fields.Exchange("is_simulation", isSimulated);
  fields.ExchangeIfSet("simulated_level", participant.SimulatedLevel);
  // As text: a number of JSON would lose bits of it.
  std::string seed = std::to_string(participant.SimulationSeed);
  fields.Exchange("simulation_seed", seed);
  fields.Require(isSimulated == !participant.SimulatedLevel.empty() && !seed.empty() &&
                     seed.size() < 20 && seed.find_first_not_of("0123456789") == std::string::npos,
                 "does not say whether it is a simulation", LineRemedy);
  participant.SimulationSeed = fields.IsReading() ? std::stoull(seed) : participant.SimulationSeed;
}

void ExchangeBeginning(JsonFields& fields, TaskBeginning& beginning)
{
  fields.ExchangeFormat("palpate-task-log", "a log of a task");
  int version = LogVersion;
  fields.Exchange("version", version, LogVersion, LogVersion);
  fields.Exchange("task", beginning.TaskId);
  fields.Exchange("digest", beginning.Digest);
  fields.Exchange("kind", beginning.Kind,
                  {"nodule", "landmarks", "outline", "mask", "dock", "path"});
  fields.Exchange("conditions", beginning.Conditions);
  fields.Exchange("participant", beginning.Participant.Number, 1, MostParticipants);
  ExchangeSimulation(fields, beginning.Participant);
  ExchangeReplies(fields, beginning.Participant.Answers);
  fields.RefuseOthers();
}

void ExchangeConduct(JsonFields& fields, TaskConduct& conduct)
{
  fields.Exchange("ended_by", conduct.End, {"done", "time", "force", "given-up"});
  fields.Exchange("seconds", conduct.Seconds, 0.0, LargestMeasure);
  fields.Exchange("force_mean_n", conduct.MeanForce, 0.0, LargestMeasure);
  fields.Exchange("force_peak_n", conduct.PeakForce, 0.0, LargestMeasure);
  fields.Exchange("touched_s", conduct.TouchedSeconds, 0.0, LargestMeasure);
  fields.Exchange("contacts", conduct.Contacts, 0, std::numeric_limits<int>::max());
  fields.Exchange("depth_max_mm", conduct.DeepestMillimeters, 0.0, LargestMeasure);
  fields.Exchange("tool_path_mm", conduct.PathMillimeters, 0.0, LargestMeasure);
}

void ExchangeMeasures(JsonFields& fields, TaskScore& score, TaskKind kind)
{
  const auto& names = TaskMeasures(kind);
  score.Values.resize(names.size(), std::nan(""));
  for (std::size_t i = 0; i < names.size(); ++i)
  {
    std::optional<double> value;
    if (!fields.IsReading() && std::isfinite(score.Values[i]))
    {
      value = score.Values[i];
    }
    fields.Exchange(names[i].c_str(), value, -LargestMeasure, LargestMeasure);
    score.Values[i] = value.value_or(std::nan(""));
  }
}

void ExchangeEvent(JsonFields& fields, TaskEvent& event, TaskKind kind)
{
  fields.Exchange("event", event.Is, {"start", "end", "pause", "resume"});
  if (event.Is == TaskEvent::Kind::Start || event.Is == TaskEvent::Kind::End)
  {
    fields.Exchange("trial", event.Trial, 1, std::numeric_limits<int>::max());
    fields.Exchange("attempt", event.Attempt, 1, std::numeric_limits<int>::max());
    fields.Exchange("training", event.IsTraining);
    fields.Exchange("condition", event.Condition);
    fields.Exchange("target", event.Target);
  }
  if (event.Is == TaskEvent::Kind::End)
  {
    fields.ExchangeObject("conduct", event.Conduct, ExchangeConduct);
    fields.Exchange("success", event.Score.IsSuccess);
    fields.ExchangeObject("measures", event.Score,
                          [kind](JsonFields& entry, TaskScore& score)
                          { ExchangeMeasures(entry, score, kind); });
    fields.Skip({"answer"});
  }
  fields.RefuseOthers();
}

// JSON has no NaN: a landmark that was left out is a list of nulls.
nlohmann::ordered_json AnswerJson(const TaskAnswer& answer, TaskKind kind)
{
  nlohmann::ordered_json json = nlohmann::ordered_json::object();
  if (kind == TaskKind::Dock)
  {
    json["shift_mm"] = PointJson(answer.Shift);
    json["turn_degrees"] = PointJson(answer.Turn);
    return json;
  }
  if (kind == TaskKind::Nodule)
  {
    json["diameter_mm"] = answer.Diameter;
  }
  json["points_mm"] = nlohmann::ordered_json::array();
  for (const Vector3& point : answer.PointsWorld)
  {
    json["points_mm"].push_back(PointJson(point));
  }
  return json;
}

TaskEvent EventOf(const TaskSettings& task, const TaskTrial& trial, int attempt)
{
  TaskEvent event;
  event.Trial = trial.Number;
  event.Attempt = attempt;
  event.IsTraining = trial.IsTraining;
  event.Condition = task.Conditions[trial.Condition].Id;
  event.Target = task.Targets[trial.Target].Id;
  return event;
}

nlohmann::ordered_json EventJson(TaskEvent event, TaskKind kind)
{
  nlohmann::ordered_json json;
  JsonFields fields(json);
  ExchangeEvent(fields, event, kind);
  return json;
}
} // namespace

const char* NameOf(TaskEnd end)
{
  return EndNames.at(static_cast<std::size_t>(end));
}

std::string TaskBeginLine(const TaskSettings& task, const TaskParticipant& participant)
{
  TaskBeginning beginning{task.Id, TaskDigest(task), task.Kind, {}, participant};
  for (const TaskCondition& condition : task.Conditions)
  {
    beginning.Conditions.push_back(condition.Id);
  }
  nlohmann::ordered_json json;
  JsonFields fields(json);
  ExchangeBeginning(fields, beginning);
  return json.dump();
}

std::string TaskStartLine(const TaskSettings& task, const TaskTrial& trial, int attempt)
{
  return EventJson(EventOf(task, trial, attempt), task.Kind).dump();
}

std::string TaskEndLine(const TaskSettings& task, const TaskTrial& trial, int attempt,
                        const TaskAnswer& answer, const TaskConduct& conduct,
                        const TaskScore& score)
{
  TaskEvent event = EventOf(task, trial, attempt);
  event.Is = TaskEvent::Kind::End;
  event.Conduct = conduct;
  event.Score = score;
  nlohmann::ordered_json json = EventJson(event, task.Kind);
  json["answer"] = AnswerJson(answer, task.Kind);
  return json.dump();
}

std::string TaskPauseLine(bool begins)
{
  TaskEvent event;
  event.Is = begins ? TaskEvent::Kind::Pause : TaskEvent::Kind::Resume;
  return EventJson(event, TaskKind::Landmarks).dump();
}

TaskBeginning ReadTaskBeginning(const std::string& line, const std::filesystem::path& path)
{
  const nlohmann::json root = ParseJson(line, path, LineRemedy);
  JsonFields fields(root, path, "line 1");
  TaskBeginning beginning;
  ExchangeBeginning(fields, beginning);
  return beginning;
}

TaskEvent ReadTaskEvent(const std::string& line, const std::filesystem::path& path,
                        std::size_t number, TaskKind kind)
{
  const nlohmann::json root = ParseJson(line, path, LineRemedy);
  JsonFields fields(root, path, "line " + std::to_string(number));
  TaskEvent event;
  ExchangeEvent(fields, event, kind);
  return event;
}
} // namespace palpate
