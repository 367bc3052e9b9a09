#include "CaseText.h"

#include "ScreenText.h"

namespace palpate
{
namespace
{
bool StartsWith(const std::string& text, const std::string& start)
{
  return text.compare(0, start.size(), start) == 0;
}
} // namespace

OutcomeText TextOf(FitResult::Outcome outcome)
{
  switch (outcome)
  {
  case FitResult::Outcome::Fitted:
    return {"fitted", "Fitted", "good"};
  case FitResult::Outcome::Refused:
    return {"refused", "Refused", "poor"};
  case FitResult::Outcome::BadInput:
    return {"bad-input", "Bad input", "bad"};
  default:
    return {"failed", "Failed", "bad"};
  }
}

std::string CoverageWord(const DirectionCoverage& coverage)
{
  switch (coverage.Outcome)
  {
  case DirectionCoverage::Verdict::Good:
    return "good";
  case DirectionCoverage::Verdict::Gaps:
    return "gaps";
  default:
    return "undetermined";
  }
}

std::string CaseTitle(const std::filesystem::path& input, const Segment& structure)
{
  if (structure.Label == 0) // a surface, or a file without a structure
  {
    return Printable(input.string());
  }
  const std::string title = input.string() + ", label " + std::to_string(structure.Label);
  return Printable(structure.Name.empty() ? title : title + " (" + structure.Name + ")");
}

std::string CaseMessage(const std::filesystem::path& input, const Segment& structure,
                        const std::string& message)
{
  const bool isOfFile = structure.Label == 0 && structure.Name.empty();
  if (isOfFile || StartsWith(message, input.string()))
  {
    return message;
  }
  const bool isPredicate =
      StartsWith(message, "is ") || StartsWith(message, "has ") || StartsWith(message, "needs ");
  return CaseTitle(input, structure) + (isPredicate ? " " : ": ") + message;
}
} // namespace palpate
