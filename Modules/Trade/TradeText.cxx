#include "TradeText.h"

#include "JsonSchema.h"
#include "SceneWords.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using JsonObject = nlohmann::ordered_json;

JsonObject NumberOf(double number)
{
  return std::isfinite(number) ? JsonObject(number) : JsonObject(nullptr);
}

JsonObject AsJson(const TradeRow& row)
{
  const bool isMeasured = row.State == TradeRow::Outcome::Measured;
  JsonObject json{{"setting", Describe(row.Setting)},
                  {"key", KeyOf(row.Setting)},
                  {"representation",
                   *(RepresentationWords.begin() + static_cast<int>(row.Setting.Representation))},
                  {"knob", TradeKnobWords.at(static_cast<std::size_t>(row.Knob))},
                  {"outcome", isMeasured ? "measured" : "refused"}};
  if (!isMeasured)
  {
    json["sentence"] = row.Message;
    return json;
  }
  json["represented"] = row.Represented;
  for (const TradeColumn& column : TradeColumns())
  {
    json[column.Name] = NumberOf(row.*column.Number);
  }
  return json;
}

JsonObject AsJson(const TradeStructureResult& structure)
{
  JsonObject rows = JsonObject::array();
  for (const TradeRow& row : structure.Rows)
  {
    rows.push_back(AsJson(row));
  }
  const TradeAdvice& advice = structure.Advice;
  const auto chosen =
      advice.Row ? JsonObject(KeyOf(structure.Rows[*advice.Row].Setting)) : JsonObject(nullptr);
  return {{"name", structure.Name},
          {"truth", structure.Rows.empty() ? std::string() : structure.Rows.front().Truth},
          {"advice", {{"met", advice.IsMet}, {"choose", chosen}, {"sentence", advice.Sentence}}},
          {"rows", rows}};
}
} // namespace

std::vector<std::string> RefusalsOf(const TradeStructureResult& structure)
{
  std::vector<const TradeRow*> firsts; // of each reason
  std::map<std::string, int> counts;
  for (const TradeRow& row : structure.Rows)
  {
    if (row.State == TradeRow::Outcome::Refused && ++counts[row.Message] == 1)
    {
      firsts.push_back(&row);
    }
  }
  std::vector<std::string> sentences;
  for (const TradeRow* first : firsts)
  {
    const int others = counts[first->Message] - 1;
    sentences.push_back(Describe(first->Setting) +
                        (others > 0 ? " and " + std::to_string(others) + " more" : std::string()) +
                        ": " + first->Message);
  }
  return sentences;
}

std::string TradeJson(const TradeResult& result)
{
  JsonObject structures = JsonObject::array();
  for (const TradeStructureResult& structure : result.Structures)
  {
    structures.push_back(AsJson(structure));
  }
  const TradeRunSettings& settings = result.Settings;
  const JsonObject json{{JsonSchemaKey, JsonSchemaVersion},
                        {"format", "palpate-tradeoff"},
                        {"program", settings.Program},
                        {"machine", result.Machine},
                        {"servo_rate_hz", settings.Scene.Rate},
                        {"tool_radius_mm", settings.Scene.Tool.Radius},
                        {"path",
                         {{"seed", settings.Path.Seed},
                          {"seconds", settings.Path.Seconds},
                          {"most_depth_mm", settings.Path.MostDepth},
                          {"runs", settings.Runs}}},
                        {"structures", structures}};
  return json.dump(2, ' ', false, JsonObject::error_handler_t::replace) + "\n";
}
} // namespace palpate
