#include "FitSettingsText.h"

#include <locale>
#include <sstream>

namespace palpate
{
namespace
{
std::string Text(double value)
{
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << value;
  return text.str();
}

std::string CenterText(const FitSettings& settings)
{
  if (settings.GivenCenterWorld)
  {
    const auto& center = *settings.GivenCenterWorld;
    return Text(center[0]) + "," + Text(center[1]) + "," + Text(center[2]);
  }
  return FitWords::Of(FitWords::Center, settings.Center);
}

std::string ComponentText(const FitSettings& settings)
{
  return settings.Component == FitSettings::EachPart ? "each"
         : settings.Component == 0                   ? "all"
         : settings.WantsOneComponent()              ? std::to_string(settings.Component)
                                                     : "largest";
}
} // namespace

std::vector<std::pair<std::string, std::string>> DescribeSettings(const FitSettings& settings)
{
  std::vector<std::pair<std::string, std::string>> result{
      {"rules", std::to_string(settings.Rules)},
      {"model", FitWords::Of(FitWords::Model, settings.Model)},
      {"method", FitWords::Of(FitWords::Method, settings.Method)},
      {"smoothing", Text(settings.Smoothing)},
      {"component", ComponentText(settings)},
      {"frequency", std::to_string(settings.Frequency)},
      {"center", CenterText(settings)},
      {"degree", settings.Tolerance ? "auto" : std::to_string(settings.Degree)}};
  if (settings.Tolerance)
  {
    const bool isOfVoxels = *settings.Tolerance == 0.0 && settings.Rules > 1;
    result.emplace_back("tolerance", isOfVoxels ? "by the voxels" : Text(*settings.Tolerance));
    result.emplace_back("max-degree", std::to_string(settings.MaximumDegree));
  }
  result.emplace_back("weights", FitWords::Of(FitWords::Weight, settings.Weight));
  result.emplace_back("penalty", settings.PenaltyKind == FitSettings::Penalty::Given
                                     ? Text(settings.Roughness)
                                     : FitWords::Of(FitWords::Penalty, settings.PenaltyKind));
  result.emplace_back("robust", settings.IsRobust ? "yes" : "no");
  result.emplace_back("repair", settings.Repairs ? "yes" : "no");
  result.emplace_back("max-hidden", Text(settings.MaximumHiddenPercent));
  result.emplace_back("min-dice", Text(settings.MinimumDice));
  return result;
}
} // namespace palpate
