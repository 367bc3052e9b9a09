#include "TaskFile.h"

#include "ContentDigest.h"
#include "JsonFields.h"
#include "JsonText.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestTask = 1 << 24; // bytes
constexpr int TaskVersion = 1;
constexpr double FarthestPoint = 1e4; // mm
constexpr std::size_t MostPoints = 2000;
constexpr std::size_t MostTargets = 1000;
constexpr std::size_t MostConditions = 12;
constexpr std::size_t MostQuestions = 50;
constexpr std::size_t LongestId = 48;
constexpr std::size_t LongestTitle = 200;
constexpr std::size_t LongestText = 5000;

bool IsId(const std::string& text)
{
  return !text.empty() && text.size() <= LongestId &&
         std::all_of(text.begin(), text.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '-' || c == '_'; });
}

void ExchangeId(JsonFields& fields, const char* key, std::string& id)
{
  fields.Exchange(key, id);
  fields.Require(IsId(id), "has no usable \"" + std::string(key) + "\" in its " + fields.Place(),
                 "write 1 to 48 letters without accents, digits, - or _");
}

void ExchangeText(JsonFields& fields, const char* key, std::string& text, std::size_t longest)
{
  fields.ExchangeIfSet(key, text);
  fields.Require(text.size() <= longest,
                 "has too long a \"" + std::string(key) + "\" in its " + fields.Place(),
                 "write at most " + std::to_string(longest) + " characters");
}

// Without equal ones, and at least one and at most `most` of them.
template <typename T>
void RequireList(const JsonFields& fields, const char* key, const std::vector<T>& list,
                 std::size_t least, std::size_t most, std::string T::*id)
{
  std::set<std::string> ids;
  for (const T& one : list)
  {
    fields.Require((one.*id).empty() || ids.insert(one.*id).second,
                   "has two \"" + std::string(key) + "\" named " + one.*id + " in its " +
                       fields.Place(),
                   "name them differently");
  }
  fields.Require(list.size() >= least && list.size() <= most,
                 "has " + std::to_string(list.size()) + " \"" + key + "\" in its " + fields.Place(),
                 "list " + std::to_string(least) + " to " + std::to_string(most));
}

void ExchangePoint(JsonFields& fields, TaskPoint& point)
{
  ExchangeText(fields, "name", point.Name, LongestTitle);
  fields.Exchange("at_mm", point.PointWorld, -FarthestPoint, FarthestPoint);
  fields.Require(fields.Has("at_mm"), "has no \"at_mm\" in its " + fields.Place(),
                 "write \"at_mm\": [x, y, z]");
}

void ExchangePose(JsonFields& fields, TaskPose& pose)
{
  fields.Exchange("shift_mm", pose.Shift, -FarthestPoint, FarthestPoint);
  fields.Exchange("turn_degrees", pose.Turn, -180.0, 180.0);
}

void ExchangeNodule(JsonFields& fields, TaskTarget& target)
{
  fields.Exchange("diameter_mm", target.Diameter, 0.0, 1000.0);
  fields.Exchange("side", target.Side, -1.0, 1.0);
  fields.Exchange("reach_mm", target.Reach, 1.0, 200.0);
  fields.Require(std::abs(target.Side.norm() - 1.0) < 1e-3,
                 "has a \"side\" that is no unit vector in its " + fields.Place(),
                 "write \"side\": [0, 1, 0] for posterior");
  fields.Require((target.Diameter > 0.0) == !target.Points.empty(),
                 "gives only one of \"diameter_mm\" and \"points\" in its " + fields.Place(),
                 "give both, or none for an organ without a nodule");
}

// The rounding of points in a file tilts a plane by less.
bool IsFlat(const std::vector<TaskPoint>& points)
{
  Vector3 normal = Vector3::Zero(); // Newell's
  Vector3 least = points.front().PointWorld;
  Vector3 most = least;
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    const Vector3& point = points[i].PointWorld;
    normal += point.cross(points[(i + 1) % points.size()].PointWorld);
    least = least.cwiseMin(point);
    most = most.cwiseMax(point);
  }
  const double size = (most - least).norm();
  const double area = normal.norm();
  return area > 1e-6 * size * size &&
         std::all_of(points.begin(), points.end(),
                     [&](const TaskPoint& point)
                     {
                       const Vector3 from = point.PointWorld - points.front().PointWorld;
                       return std::abs(from.dot(normal)) <= 1e-3 * size * area;
                     });
}

std::size_t LeastPoints(TaskKind kind)
{
  switch (kind)
  {
  case TaskKind::Landmarks:
  case TaskKind::Dock:
    return 1;
  case TaskKind::Outline:
    return 3;
  case TaskKind::Path:
    return 2;
  default:
    return 0;
  }
}

std::size_t LargestCount(TaskKind kind)
{
  return kind == TaskKind::Nodule || kind == TaskKind::Dock ? 1
         : kind == TaskKind::Mask                           ? 0
                                                            : MostPoints;
}

void ExchangeTarget(JsonFields& fields, TaskTarget& target, TaskKind kind)
{
  ExchangeId(fields, "id", target.Id);
  fields.Exchange("scene", target.Scene);
  fields.Require(!target.Scene.empty(), "has no \"scene\" in its " + fields.Place(),
                 "name a scene file (.scene.json)");
  fields.ExchangeIfSet("image", target.Image);
  fields.ExchangeIfSet("training", target.IsTraining);
  fields.Exchange("tolerance_mm", target.Tolerance, 0.0, 1000.0);
  if (kind != TaskKind::Mask)
  {
    fields.ExchangeList("points", target.Points, ExchangePoint);
  }
  RequireList(fields, "points", target.Points, LeastPoints(kind), LargestCount(kind),
              &TaskPoint::Name);
  if (kind == TaskKind::Nodule)
  {
    ExchangeNodule(fields, target);
  }
  else if (kind == TaskKind::Outline && fields.IsReading())
  {
    fields.Require(IsFlat(target.Points), "has no flat outline in its " + fields.Place(),
                   "list the points of one closed contour in a plane");
  }
  else if (kind == TaskKind::Mask)
  {
    fields.Exchange("mask", target.Mask);
    fields.Require(!target.Mask.empty(), "has no \"mask\" in its " + fields.Place(),
                   "name the true mask");
  }
  else if (kind == TaskKind::Dock)
  {
    fields.ExchangeObject("pose", target.Pose, ExchangePose);
    fields.Exchange("tolerance_degrees", target.AngleTolerance, 0.0, 180.0);
  }
}

void ExchangeCondition(JsonFields& fields, TaskCondition& condition)
{
  ExchangeId(fields, "id", condition.Id);
  fields.Exchange("force", condition.HasForce);
  fields.ExchangeIfSet("scene_patch", condition.Patch);
}

void ExchangeQuestion(JsonFields& fields, TaskQuestion& question)
{
  ExchangeId(fields, "key", question.Key);
  ExchangeText(fields, "text", question.Text, LongestTitle);
  fields.ExchangeIfSet("choices", question.Choices);
  if (question.Choices.empty())
  {
    fields.Exchange("least", question.Least, -1e6, 1e6);
    fields.Exchange("most", question.Most, question.Least, 1e6);
  }
  fields.Require(question.Choices.size() <= MostQuestions &&
                     std::all_of(question.Choices.begin(), question.Choices.end(), IsId),
                 "has an unusable choice in its " + fields.Place(),
                 "write up to 50 words of letters, digits, - or _");
  fields.Require(!AsksForIdentity(question.Key) && !AsksForIdentity(question.Text),
                 "asks who a participant is in its " + fields.Place(),
                 "remove the question: participants are numbers, and no names are stored");
}

void ExchangeCounts(JsonFields& fields, TaskSettings& task)
{
  fields.Exchange("trials", task.Trials, 1, 1000);
  fields.Exchange("training_trials", task.TrainingTrials, 0, 100);
  fields.ExchangeIfSet("most_seconds", task.MostSeconds, 0.0, 36000.0);
  fields.ExchangeIfSet("most_force_n", task.MostForce, 0.0, 100.0);
  fields.ExchangeIfSet("pause_after_trials", task.PauseAfter, 0, 1000);
  fields.ExchangeIfSet("pause_seconds", task.PauseSeconds, 0.0, 36000.0);
  fields.Exchange("seed", task.Seed, 0, 1000000000);
  if (fields.IsReading() || !task.IsRecorded) // as the digests of earlier versions
  {
    fields.Exchange("record", task.IsRecorded);
  }
}

void RequireTargets(const JsonFields& fields, const TaskSettings& task)
{
  const auto trained = std::count_if(task.Targets.begin(), task.Targets.end(),
                                     [](const TaskTarget& target) { return target.IsTraining; });
  fields.Require(trained < static_cast<std::ptrdiff_t>(task.Targets.size()),
                 "has no targets but those for training",
                 "remove \"training\" from at least one of its targets");
}

void ExchangeTask(JsonFields& fields, TaskSettings& task)
{
  fields.ExchangeFormat("palpate-task", "a task");
  int version = TaskVersion;
  fields.Exchange("version", version, TaskVersion, TaskVersion);
  ExchangeId(fields, "id", task.Id);
  ExchangeText(fields, "title", task.Title, LongestTitle);
  std::string kind = NameOf(task.Kind);
  fields.Exchange("kind", kind, TaskKindNames());
  fields.Require(fields.Has("kind"), "has no \"kind\"", "write \"kind\": \"landmarks\"");
  const auto& kinds = TaskKindNames();
  task.Kind = static_cast<TaskKind>(std::find(kinds.begin(), kinds.end(), kind) - kinds.begin());
  ExchangeText(fields, "instructions", task.Instructions, LongestText);
  fields.ExchangeList("ask", task.Questions, ExchangeQuestion);
  RequireList(fields, "ask", task.Questions, 0, MostQuestions, &TaskQuestion::Key);
  fields.ExchangeList("conditions", task.Conditions, ExchangeCondition);
  RequireList(fields, "conditions", task.Conditions, 1, MostConditions, &TaskCondition::Id);
  ExchangeCounts(fields, task);
  fields.ExchangeList("targets", task.Targets,
                      [&task](JsonFields& entry, TaskTarget& target)
                      { ExchangeTarget(entry, target, task.Kind); });
  RequireList(fields, "targets", task.Targets, 1, MostTargets, &TaskTarget::Id);
  RequireTargets(fields, task);
  fields.RefuseOthers();
}
} // namespace

const std::vector<std::string>& TaskKindNames()
{
  static const std::vector<std::string> names{"nodule", "landmarks", "outline",
                                              "mask",   "dock",      "path"};
  return names;
}

const std::string& NameOf(TaskKind kind)
{
  return TaskKindNames().at(static_cast<std::size_t>(kind));
}

bool AsksForIdentity(const std::string& text)
{
  static const std::set<std::string> words{
      "name",     "names", "firstname", "lastname", "surname",  "forename", "nickname",
      "initials", "email", "mail",      "phone",    "address",  "birthday", "birthdate",
      "birth",    "dob",   "mrn",       "patient",  "passport", "signature"};
  std::string word;
  for (const char letter : text + " ")
  {
    const auto byte = static_cast<unsigned char>(letter);
    if (std::isalpha(byte) != 0)
    {
      word += static_cast<char>(std::tolower(byte));
      continue;
    }
    if (words.count(word) > 0)
    {
      return true;
    }
    word.clear();
  }
  return false;
}

TaskSettings ReadTask(const std::filesystem::path& path)
{
  const nlohmann::json root =
      ReadJson(path, LargestTask, "write a task as Documentation/HowTo/Task.md shows");
  JsonFields fields(root, path, "task", path.parent_path());
  TaskSettings task;
  ExchangeTask(fields, task);
  return task;
}

std::string TaskText(TaskSettings task, const std::filesystem::path& folder)
{
  nlohmann::ordered_json root;
  JsonFields fields(root, folder);
  ExchangeTask(fields, task);
  return root.dump(2) + "\n";
}

std::string TaskDigest(const TaskSettings& task)
{
  ContentDigest digest;
  // Where the files lie does not matter.
  TaskSettings named = task;
  for (TaskTarget& target : named.Targets)
  {
    target.Scene = target.Scene.filename();
    target.Mask = target.Mask.filename();
    target.Image = target.Image.filename();
  }
  for (TaskCondition& condition : named.Conditions)
  {
    condition.Patch = condition.Patch.filename();
  }
  digest.Add(TaskText(named, std::filesystem::current_path()));
  return digest.Text();
}
} // namespace palpate
