#include "JudgementText.h"

#include "CheckRule.h"
#include "DecimalText.h"
#include "Units.h"

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

std::string FewCasesText(std::size_t cases)
{
  return "a group needs " + std::to_string(CheckGroup::LeastCases) +
         " clean cases of a structure, but there are " + std::to_string(cases) +
         "; check without a group instead";
}
} // namespace palpate
