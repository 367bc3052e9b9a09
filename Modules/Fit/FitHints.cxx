#include "FitHints.h"

#include <vector>

namespace palpate
{
namespace
{
bool UsesMostVisible(const FitSettings& settings)
{
  return settings.Center == FitSettings::CenterChoice::MostVisible && !settings.GivenCenterWorld;
}

std::string DegreeOption(const FitSettings& settings)
{
  return settings.Tolerance ? "another --max-degree" : "another --degree";
}

// "a, b or c".
std::string AnyOf(const std::vector<std::string>& choices)
{
  std::string text;
  for (std::size_t i = 0; i < choices.size(); ++i)
  {
    text += (i == 0 ? "" : i + 1 == choices.size() ? " or " : ", ") + choices[i];
  }
  return text;
}

std::vector<std::string> WindowChoices(const FitSettings& settings)
{
  std::vector<std::string> choices{"another degree", "a higher Frequency"};
  if (!UsesMostVisible(settings))
  {
    choices.emplace_back("the most visible Centre");
  }
  return choices;
}

std::vector<std::string> Choices(const FitSettings& settings)
{
  std::vector<std::string> choices{DegreeOption(settings), "a higher --frequency"};
  if (!UsesMostVisible(settings))
  {
    choices.emplace_back("--center visible");
  }
  return choices;
}
} // namespace

std::string HintForHidden(const FitSettings& settings)
{
  const std::string raise = "raise --max-hidden to see what is lost";
  return UsesMostVisible(settings) ? raise : "try --center visible, or " + raise;
}

std::string HintForMisfit(const FitSettings& settings)
{
  return "try " + AnyOf(Choices(settings)) + ", or lower --min-dice to see it";
}

std::string HintForImplausible(const FitSettings& settings)
{
  std::vector<std::string> choices = Choices(settings);
  if (settings.PenaltyKind == FitSettings::Penalty::None)
  {
    choices.emplace_back("--penalty auto");
  }
  return "try " + AnyOf(choices);
}

std::string OptionsOfFit(const FitSettings& settings)
{
  return settings.Tolerance ? "(--tolerance, --max-degree, --frequency)"
                            : "(--degree, --frequency, --penalty)";
}

std::string HintForTooFewVoxels()
{
  return "choose another --label or --component";
}

std::string WindowHintForHidden(const FitSettings& settings)
{
  const std::string raise = "raise Maximum hidden to see what is lost";
  return UsesMostVisible(settings) ? raise : "try the most visible Centre, or " + raise;
}

std::string WindowHintForMisfit(const FitSettings& settings)
{
  return "try " + AnyOf(WindowChoices(settings)) + ", or lower Minimum Dice to see it";
}

std::string WindowHintForImplausible(const FitSettings& settings)
{
  return "try " + AnyOf(WindowChoices(settings));
}

std::string WithHint(const std::string& reason, const std::string& hint)
{
  if (hint.empty())
  {
    return reason;
  }
  return reason + (hint.front() == '(' ? " " : "; ") + hint;
}
} // namespace palpate
