#include "DrillScript.h"

#include "JsonFields.h"
#include "JsonText.h"
#include "Refusal.h"

namespace palpate
{
namespace
{
constexpr const char* Format = "palpate-drill";
constexpr std::uintmax_t LargestFile = 1 << 24;
constexpr double LongestTime = 36000.0; // s
const std::initializer_list<const char*> Words{"start", "stop", "end-stroke",
                                               "undo",  "redo", "reset"};
} // namespace

std::vector<DrillAction> ReadDrillScript(const std::filesystem::path& path)
{
  const nlohmann::json root =
      ReadJson(path, LargestFile, "write it as Documentation/HowTo/Drill.md shows");
  JsonFields fields(root, path, "script");
  std::string format;
  fields.Exchange("format", format);
  if (format != Format)
  {
    Refuse(path, "is not marked as a drill script",
           "begin it with \"format\": \"" + std::string(Format) + "\"");
  }
  if (!fields.Has("actions") || !root["actions"].is_array() || root["actions"].empty())
  {
    Refuse(path, "has no actions",
           "list its \"actions\": [ { \"time_s\": 0, \"do\": \"start\" } ]");
  }
  fields.RefuseOthers();
  std::vector<DrillAction> actions;
  for (const nlohmann::json& object : root["actions"])
  {
    const std::string place = "actions[" + std::to_string(actions.size()) + "]";
    JsonFields entry(object, path, place);
    DrillAction action;
    entry.Exchange("time_s", action.Time, 0.0, LongestTime);
    entry.Exchange("do", action.Do, Words);
    if (!entry.Has("do") || (!actions.empty() && action.Time < actions.back().Time))
    {
      Refuse(path, "has " + place + " without an action, or out of order",
             "give each a \"do\", and sort them by \"time_s\"");
    }
    entry.RefuseOthers();
    actions.push_back(action);
  }
  return actions;
}

DrillCommand CommandOf(DrillAction::Kind kind)
{
  switch (kind)
  {
  case DrillAction::Kind::EndStroke:
    return DrillCommand::EndStroke;
  case DrillAction::Kind::Undo:
    return DrillCommand::Undo;
  case DrillAction::Kind::Redo:
    return DrillCommand::Redo;
  case DrillAction::Kind::Reset:
    return DrillCommand::Reset;
  default:
    return DrillCommand::None;
  }
}
} // namespace palpate
