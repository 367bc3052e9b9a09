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

std::vector<std::string> Choices(const FitSettings& settings, const HintWords& words)
{
  std::vector<std::string> choices{settings.Tolerance ? words.MaximumDegree : words.Degree};
  if (settings.Model == FitSettings::ModelKind::Surface)
  {
    return choices;
  }
  choices.emplace_back(words.Frequency);
  if (!UsesMostVisible(settings))
  {
    choices.emplace_back(words.VisibleCenter);
  }
  return choices;
}
} // namespace

std::string HintForHidden(const FitSettings& settings, const HintWords& words)
{
  const std::string raise = std::string("raise ") + words.MaximumHidden + " to see what is lost";
  const std::string other = std::string("try ") + words.OrganModel + ", ";
  return UsesMostVisible(settings) ? other + "or " + raise
                                   : other + words.VisibleCenter + ", or " + raise;
}

std::string HintForRepair(const FitSettings& settings, const HintWords& words)
{
  return settings.Repairs ? std::string() : std::string("accept that by ") + words.Repair;
}

std::string HintForEachPart(const FitSettings& /*settings*/, const HintWords& words)
{
  return std::string("model its parts one by one with ") + words.EachPart;
}

std::string HintForParts(const FitSettings& settings, const HintWords& words)
{
  return HintForEachPart(settings, words) + ", or " + HintForRepair(settings, words);
}

std::string HintForOpenSurface(const FitSettings& settings, const HintWords& words)
{
  const std::string need = "a model needs one closed surface without handles and crossings";
  const std::string part =
      settings.WantsOneComponent() || words.Part[0] == '\0'
          ? std::string()
          : std::string("; of several parts, ") + words.Part + " 1 keeps the largest alone";
  return (settings.Repairs ? need : need + ", which " + words.Repair + " makes by way of voxels") +
         part;
}

std::string HintForMisfit(const FitSettings& settings, const HintWords& words)
{
  return HintForDegree(settings, words) + ", or lower " + words.MinimumDice + " to see it";
}

std::string HintForDegree(const FitSettings& settings, const HintWords& words)
{
  return "try " + AnyOf(Choices(settings, words));
}

std::string HintForImplausible(const FitSettings& settings, const HintWords& words)
{
  std::vector<std::string> choices = Choices(settings, words);
  if (settings.PenaltyKind == FitSettings::Penalty::None && words.Penalty[0] != '\0')
  {
    choices.emplace_back(words.Penalty);
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

std::string HintForShape()
{
  return "palpate touch feels it as it is";
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
