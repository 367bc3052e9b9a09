#include "DrillScript.h"

#include "JsonFields.h"
#include "JsonText.h"

namespace palpate
{
namespace
{
constexpr std::uintmax_t LargestScript = 1 << 24;
constexpr double LongestTime = 36000.0; // s
const std::initializer_list<const char*> Words{"start", "stop", "end-stroke",
                                               "undo",  "redo", "reset"};
} // namespace

std::vector<DrillAction> ReadDrillScript(const std::filesystem::path& path)
{
  const nlohmann::json root =
      ReadJson(path, LargestScript, "write it as Documentation/HowTo/Drill.md shows");
  JsonFields fields(root, path, "script");
  fields.ExchangeFormat("palpate-drill", "a drill script");
  std::vector<DrillAction> actions;
  double last = 0.0;
  fields.ExchangeList("actions", actions,
                      [&last](JsonFields& entry, DrillAction& action)
                      {
                        entry.Exchange("time_s", action.Time, 0.0, LongestTime);
                        entry.Exchange("do", action.Do, Words);
                        entry.Require(entry.Has("do") && action.Time >= last,
                                      "has " + entry.Place() +
                                          " without an action, or out of order",
                                      "give each a \"do\", and sort them by \"time_s\"");
                        last = action.Time;
                      });
  fields.Require(!actions.empty(), "has no actions",
                 "list its \"actions\": [ { \"time_s\": 0, \"do\": \"start\" } ]");
  fields.RefuseOthers();
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
