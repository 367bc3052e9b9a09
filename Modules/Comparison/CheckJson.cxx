#include "CheckJson.h"

#include "CheckText.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "JsonNumbers.h"
#include "JsonSchema.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace palpate
{
namespace
{
using Json = nlohmann::ordered_json;

Json OrganCheckJson(const CheckedOrgan& organ, const OrganJudgement& judgement)
{
  Json statistics = Json::array();
  for (const MaskStatistic& one : organ.Measured.Statistics)
  {
    statistics.push_back(
        {{"rule", one.Key}, {"value", std::isfinite(one.Value) ? Json(one.Value) : Json()}});
  }
  const bool isPlausible = judgement.Is == OrganJudgement::Verdict::Plausible;
  Json others = Json::array();
  for (const MaskStatistic& one : judgement.Others)
  {
    others.push_back(one.Key);
  }
  return {{"name", organ.Name},
          {"verdict", VerdictWord(judgement.Is)},
          {"sentence", organ.Name + " " + JudgementSentence(judgement)},
          {"rule", isPlausible ? Json() : Json(judgement.Reason.Key)},
          {"place_mm", isPlausible ? Json::array() : PointJson(judgement.Reason.Place)},
          {"by", judgement.IsByGroup ? "group" : "limits"},
          {"p_case", judgement.IsByGroup ? Json(judgement.Probability) : Json()},
          {"score",
           judgement.IsByGroup && std::isfinite(judgement.Score) ? Json(judgement.Score) : Json()},
          {"other_rules", others},
          {"volume_ml", organ.Measured.Milliliters},
          {"statistics", statistics}};
}
} // namespace

std::string CheckJson(const MaskChecks& checks, const std::string& folder)
{
  Json cases = Json::array();
  for (const CaseCheck& one : checks.Cases)
  {
    Json organs = Json::array();
    for (std::size_t n = 0; n < one.Judgements.size(); ++n)
    {
      organs.push_back(OrganCheckJson(one.Patient.Organs[n], one.Judgements[n]));
    }
    std::vector<std::string> notes = one.Notes;
    for (const RefusedMask& mask : one.Refused)
    {
      notes.push_back(mask.Message);
    }
    cases.push_back({{"name", one.Name},
                     {"file", one.File.string()},
                     {"verdict", one.IsChecked() ? Json(VerdictWord(one.Worst())) : Json()},
                     {"message", one.Message},
                     {"notes", notes},
                     {"structures", organs}});
  }
  const Json json{{JsonSchemaKey, JsonSchemaVersion},
                  {"by", checks.IsByGroup ? "group" : "limits"},
                  {"false_alarms_percent", checks.IsByGroup ? Json(100.0 * checks.Rate) : Json()},
                  {"cases", cases},
                  {"folder", folder.empty() ? Json() : Json(folder)}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string CheckTable(const MaskChecks& checks)
{
  std::string text = CsvLine({"case", "structure", "verdict", "sentence", "rule", "left_mm",
                              "posterior_mm", "superior_mm", "by", "p_case", "volume_ml"});
  for (const CaseCheck& one : checks.Cases)
  {
    if (!one.IsChecked())
    {
      text += CsvLine({one.Name, {}, "not checked", one.Message, {}, {}, {}, {}, {}, {}, {}});
    }
    for (const RefusedMask& mask : one.Refused)
    {
      text += CsvLine({one.Name,
                       mask.File.filename().string(),
                       "not checked",
                       mask.Message,
                       {},
                       {},
                       {},
                       {},
                       {},
                       {},
                       {}});
    }
    for (std::size_t n = 0; n < one.Judgements.size(); ++n)
    {
      const CheckedOrgan& organ = one.Patient.Organs[n];
      const OrganJudgement& judgement = one.Judgements[n];
      const bool isPlausible = judgement.Is == OrganJudgement::Verdict::Plausible;
      const auto coordinate = [&](Eigen::Index axis)
      { return isPlausible ? std::string() : FixedText(judgement.Reason.Place[axis], 2); };
      text +=
          CsvLine({one.Name, organ.Name, VerdictWord(judgement.Is), JudgementSentence(judgement),
                   isPlausible ? "" : judgement.Reason.Key, coordinate(0), coordinate(1),
                   coordinate(2), judgement.IsByGroup ? "group" : "limits",
                   judgement.IsByGroup ? FixedText(judgement.Probability, 4) : "",
                   FixedText(organ.Measured.Milliliters, 3)});
    }
  }
  return text;
}
} // namespace palpate
