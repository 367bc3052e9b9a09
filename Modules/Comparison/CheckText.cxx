#include "CheckText.h"

#include "DecimalText.h"
#include "TextTable.h"

#include <array>
#include <cmath>

namespace palpate
{
const char* VerdictStyle(OrganJudgement::Verdict verdict)
{
  constexpr const char* Styles[] = {"good", "poor", "bad"};
  return Styles[static_cast<int>(verdict)];
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
