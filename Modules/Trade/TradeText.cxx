#include "TradeText.h"

#include "CsvText.h"
#include "DecimalText.h"
#include "JsonSchema.h"

#include <array>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using JsonObject = nlohmann::ordered_json;

// A number of a row and its key in files, which ends with the unit.
struct TradeColumn
{
  const char* Name;
  double TradeRow::*Number;
};

constexpr std::array<TradeColumn, 29> TradeColumns{
    {{"tick_mean_ns", &TradeRow::TickMean},
     {"tick_median_ns", &TradeRow::TickMedian},
     {"tick_p999_ns", &TradeRow::TickRare},
     {"rate_hz", &TradeRow::Rate},
     {"position_mean_mm", &TradeRow::PositionMean},
     {"position_p99_mm", &TradeRow::PositionRare},
     {"position_most_mm", &TradeRow::PositionMost},
     {"surface_mean_mm", &TradeRow::SurfaceMean},
     {"surface_most_mm", &TradeRow::SurfaceMost},
     {"force_mean_n", &TradeRow::ForceMean},
     {"force_p99_n", &TradeRow::ForceRare},
     {"noticeable_mean_jnd", &TradeRow::NoticeableMean},
     {"noticeable_p99_jnd", &TradeRow::NoticeableRare},
     {"direction_mean_degrees", &TradeRow::DirectionMean},
     {"direction_p99_degrees", &TradeRow::DirectionRare},
     {"direction_most_degrees", &TradeRow::DirectionMost},
     {"beyond_position_p99_mm", &TradeRow::BeyondPositionRare},
     {"beyond_noticeable_p99_jnd", &TradeRow::BeyondNoticeableRare},
     {"beyond_direction_p99_degrees", &TradeRow::BeyondDirectionRare},
     {"uncertainty_mean_mm", &TradeRow::UncertaintyMean},
     {"uncertainty_p99_mm", &TradeRow::UncertaintyRare},
     {"jump_mean_n", &TradeRow::JumpMean},
     {"jump_most_n", &TradeRow::JumpMost},
     {"ideal_jump_most_n", &TradeRow::IdealJumpMost},
     {"seizures", &TradeRow::Seizures},
     {"parted", &TradeRow::Parted},
     {"build_seconds", &TradeRow::BuildSeconds},
     {"cost_seconds", &TradeRow::CostSeconds},
     {"bytes", &TradeRow::Bytes}}};

JsonObject NumberOf(double number)
{
  return std::isfinite(number) ? JsonObject(number) : JsonObject(nullptr);
}

JsonObject AsJson(const TradeRow& row)
{
  const bool isMeasured = row.State == TradeRow::Outcome::Measured;
  JsonObject json{{"setting", Describe(row)},
                  {"key", KeyOf(row.Setting)},
                  {"representation", row.Setting.Structure.Representation},
                  {"outcome", isMeasured ? "measured" : "refused"}};
  if (!isMeasured)
  {
    json["message"] = row.Message;
    return json;
  }
  json["represented"] = row.Represented;
  for (const TradeColumn& column : TradeColumns)
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
          {"reference", structure.Rows.empty() ? std::string() : structure.Rows.front().Truth},
          {"advice", {{"met", advice.IsMet}, {"choose", chosen}, {"message", advice.Message}}},
          {"rows", rows}};
}
} // namespace

std::vector<std::string> RefusalsOf(const TradeStructureResult& structure)
{
  std::vector<const TradeRow*> firsts; // one per reason
  std::map<std::string, int> counts;
  for (const TradeRow& row : structure.Rows)
  {
    if (row.State == TradeRow::Outcome::Refused && ++counts[row.Message] == 1)
    {
      firsts.push_back(&row);
    }
  }
  std::vector<std::string> messages;
  for (const TradeRow* first : firsts)
  {
    const int others = counts[first->Message] - 1;
    messages.push_back(Describe(*first) +
                       (others > 0 ? " and " + std::to_string(others) + " more" : std::string()) +
                       ": " + first->Message);
  }
  return messages;
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
                         {{"seed", settings.Measurement.Path.Seed},
                          {"seconds", settings.Measurement.Path.Seconds},
                          {"most_depth_mm", settings.Measurement.Path.MostDepth},
                          {"runs", settings.Measurement.Runs}}},
                        {"structures", structures}};
  return json.dump(2, ' ', false, JsonObject::error_handler_t::replace) + "\n";
}

std::string TradeCsv(const TradeResult& result)
{
  std::vector<std::string> fields{"structure",   "setting",   "key",    "outcome",
                                  "represented", "reference", "message"};
  for (const TradeColumn& column : TradeColumns)
  {
    fields.emplace_back(column.Name);
  }
  std::string text = CsvLine(fields);
  for (const TradeStructureResult& structure : result.Structures)
  {
    for (const TradeRow& row : structure.Rows)
    {
      fields = {
          row.Structure,   Describe(row), KeyOf(row.Setting), row.IsFelt() ? "measured" : "refused",
          row.Represented, row.Truth,     row.Message};
      for (const TradeColumn& column : TradeColumns)
      {
        const double number = row.*column.Number;
        fields.push_back(std::isfinite(number) ? ExactText(number) : std::string());
      }
      text += CsvLine(fields);
    }
  }
  return text;
}
} // namespace palpate
