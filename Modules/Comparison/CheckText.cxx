#include "CheckText.h"

#include "CheckRule.h"
#include "DecimalText.h"
#include "TextTable.h"
#include "Units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>

namespace palpate
{
namespace
{
std::string VolumeText(double cubicMillimeters)
{
  return cubicMillimeters >= 100.0
             ? FixedText(cubicMillimeters / CubicMillimetersPerMilliliter, 2) + " ml"
             : FixedText(cubicMillimeters, 1) + " mm³";
}

std::string PercentText(double share)
{
  return FixedText(100.0 * share, share < 0.1 ? 1 : 0) + " %";
}

// "end_left" → "left".
std::string SideOfKey(const std::string& key)
{
  return key.substr(key.find('_') + 1);
}

using SentenceOf = std::string (*)(const MaskStatistic&);

const std::map<std::string, SentenceOf>& Sentences()
{
  using One = const MaskStatistic&;
  static const std::map<std::string, SentenceOf> sentences{
      {"side",
       [](One) { return std::string("lies on the other side of the patient than its name says"); }},
      {"gap",
       [](One one)
       {
         return "lacks " + FixedText(one.Amount, 0) + (one.Amount > 1.5 ? " slices" : " slice") +
                " between filled ones";
       }},
      {"part",
       [](One one)
       {
         const std::string beside = !one.Other           ? ""
                                    : one.Other->empty() ? ", which touches no other structure"
                                                         : ", which lies against " + *one.Other;
         return "has a part of " + VolumeText(one.Amount) + " apart from the rest (" +
                PercentText(one.Value) + " of its volume in all)" + beside;
       }},
      {"hole",
       [](One one)
       {
         return "has a hole of " + VolumeText(one.Amount) + " (" + PercentText(one.Value) +
                " of its volume in all)";
       }},
      {"overlap",
       [](One one)
       {
         return "shares " + VolumeText(one.Amount) + " with " +
                one.Other.value_or("another structure") + " (" + PercentText(one.Value) +
                " of the smaller)";
       }},
      {"pair",
       [](One one)
       {
         return "differs from the mirror image of the other side in place (" +
                FixedText(one.Amount, 1) + " mm) or volume";
       }},
      {"neck", [](One one)
       { return "has a second body at a bridge of " + FixedText(one.Amount, 1) + " mm"; }},
      {"border", [](One one)
       { return "is cut off by the border of the image (" + FixedText(one.Amount, 0) + " mm²)"; }},
      {"copied",
       [](One one)
       {
         return "is a staircase: up to " + FixedText(one.Amount, 0) +
                " equal slices follow each other";
       }},
      {"end",
       [](One one)
       {
         return "ends flat to " + SideOfKey(one.Key) + ", with " + FixedText(one.Amount, 0) +
                " % of its largest section";
       }},
      {"edge",
       [](One one)
       {
         return "ends flat to " + SideOfKey(one.Key) + ", with " + FixedText(one.Amount, 0) +
                " % of its largest section";
       }},
      {"shape",
       [](One one)
       {
         return std::string(one.Amount < 0.0 ? "has a dent" : "has a bump") +
                " that the group does not have (t " + FixedText(one.Value, 1) + ")";
       }},
      {"band_2", [](One) { return std::string("has proportions that the group does not have"); }},
      {"band_3_5",
       [](One) { return std::string("has a coarse shape that the group does not have"); }},
      {"band_6_12",
       [](One) { return std::string("has a fine shape that the group does not have"); }},
      {"rough",
       [](One one)
       {
         return "has a surface rougher than the group's (" + FixedText(one.Amount, 1) +
                " % of the radius)";
       }},
      {"step", [](One one)
       { return "jumps between two slices by " + FixedText(one.Amount, 0) + " % of their area"; }},
      {"slice_hole", [](One one)
       { return "has holes in its slices (" + PercentText(one.Value) + " of its volume)"; }},
      {"size",
       [](One one) {
         return "has " + FixedText(one.Amount, 2) + " times the volume that is usual in the group";
       }},
      {"position", [](One one) {
         return "lies " + FixedText(one.Amount, 1) + " mm from where the other structures have it";
       }}};
  return sentences;
}
} // namespace

const char* VerdictWord(OrganJudgement::Verdict verdict)
{
  constexpr const char* Words[] = {"plausible", "look here", "implausible"};
  return Words[static_cast<int>(verdict)];
}

const char* VerdictStyle(OrganJudgement::Verdict verdict)
{
  constexpr const char* Styles[] = {"good", "poor", "bad"};
  return Styles[static_cast<int>(verdict)];
}

std::string JudgementSentence(const OrganJudgement& judgement)
{
  if (judgement.Is == OrganJudgement::Verdict::Plausible)
  {
    return "shows nothing unusual";
  }
  const CheckRule* const rule = FindCheckRule(judgement.Reason.Key);
  return rule != nullptr ? Sentences().at(rule->Key)(judgement.Reason) : std::string();
}

std::string OddCaseText(const CheckGroup::Odd& odd)
{
  return odd.Organ + " " +
         (odd.Why.Key == "shape" ? "has an odd shape (t " + FixedText(odd.Why.Value, 1) + ")"
                                 : Sentences().at(odd.Why.Key)(odd.Why));
}

std::string PatientPlace(const Vector3& world)
{
  constexpr const char* Plus = "LPS";
  constexpr const char* Minus = "RAI";
  std::string text;
  for (Eigen::Index axis = 0; axis < 3; ++axis)
  {
    text += axis > 0 ? ", " : "";
    text += world[axis] < 0.0 ? Minus[axis] : Plus[axis];
    text += " " + FixedText(std::abs(world[axis]), 1);
  }
  return text;
}

std::string CheckTally(const MaskChecks& checks)
{
  std::array<int, 3> counts{};
  int cases = 0;
  for (const CaseCheck& one : checks.Cases)
  {
    cases += one.IsChecked() ? 1 : 0;
    for (const OrganJudgement& judgement : one.Judgements)
    {
      ++counts[static_cast<std::size_t>(judgement.Is)];
    }
  }
  return std::to_string(counts[0] + counts[1] + counts[2]) + " structures of " +
         std::to_string(cases) + (cases == 1 ? " case: " : " cases: ") + std::to_string(counts[0]) +
         " plausible, " + std::to_string(counts[1]) + " to look at, " + std::to_string(counts[2]) +
         " implausible";
}

std::string CheckBasis(const MaskChecks& checks)
{
  return checks.IsByGroup ? "against a group, at false alarms in " +
                                FixedText(100.0 * checks.Rate, 1) + " % of clean cases"
                          : "by fixed limits, without a group: the rate of false alarms is unknown";
}

std::string TooFewCasesText(const CheckGroup& group, double rate)
{
  return rate >= group.LeastRate()
             ? std::string()
             : "the group's " + std::to_string(group.Scores.size()) +
                   " cases are too few for false alarms in " + FixedText(100.0 * rate, 1) +
                   " % of cases; judged by fixed limits, without the group";
}

std::string CheckText(const MaskChecks& checks)
{
  TextTable table;
  table.AddRow({"case", "structure", "verdict", "it", "at mm"});
  for (const CaseCheck& one : checks.Cases)
  {
    for (std::size_t n = 0; n < one.Judgements.size(); ++n)
    {
      const OrganJudgement& judgement = one.Judgements[n];
      if (judgement.Is != OrganJudgement::Verdict::Plausible)
      {
        table.AddRow({checks.Cases.size() > 1 ? one.Name : std::string(),
                      one.Patient.Organs[n].Name, VerdictWord(judgement.Is),
                      JudgementSentence(judgement), PatientPlace(judgement.Reason.Place)});
      }
    }
  }
  const std::string tally = CheckTally(checks) + ", " + CheckBasis(checks) + "\n";
  return tally.find(" 0 to look at, 0 implausible") != std::string::npos ? tally
                                                                         : table.Text() + tally;
}
} // namespace palpate
