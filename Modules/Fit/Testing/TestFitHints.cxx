#include "FitHints.h"

#include <gtest/gtest.h>

namespace palpate::fit_hints_test
{
namespace
{

bool Names(const std::string& hint, const char* option)
{
  return hint.find(option) != std::string::npos;
}

TEST(FitHints, SuggestsVisibleCentreOnlyIfUnused)
{
  FitSettings settings;
  for (const auto hintFor :
       {palpate::HintForHidden, palpate::HintForMisfit, palpate::HintForImplausible})
  {
    const auto hint = [hintFor](const FitSettings& used) { return hintFor(used, OptionWords); };
    settings = {};
    EXPECT_TRUE(Names(hint(settings), "--center visible")) << hint(settings);
    settings.GivenCenterWorld = {1.0, 2.0, 3.0};
    EXPECT_TRUE(Names(hint(settings), "--center visible")) << hint(settings);
    settings = {};
    settings.Center = FitSettings::CenterChoice::MostVisible;
    EXPECT_FALSE(Names(hint(settings), "visible")) << hint(settings);
    EXPECT_FALSE(hint(settings).empty());
  }
}

TEST(FitHints, NamesNoOptionsInWindow)
{
  for (const auto hintFor :
       {palpate::HintForHidden, palpate::HintForMisfit, palpate::HintForImplausible})
  {
    const std::string hint = hintFor(FitSettings(), palpate::WindowWords);
    EXPECT_TRUE(Names(hint, "the most visible Centre")) << hint;
    EXPECT_FALSE(Names(hint, "--")) << hint;
  }
}

TEST(FitHints, NamesDegreeOptionInUse)
{
  FitSettings settings;
  EXPECT_TRUE(Names(palpate::HintForMisfit(settings, OptionWords), "--degree"));
  EXPECT_TRUE(Names(palpate::OptionsOfFit(settings), "--degree"));
  settings.Tolerance = 0.5;
  EXPECT_TRUE(Names(palpate::HintForMisfit(settings, OptionWords), "--max-degree"));
  EXPECT_FALSE(Names(palpate::HintForMisfit(settings, OptionWords), "another --degree"));
  EXPECT_TRUE(Names(palpate::OptionsOfFit(settings), "--tolerance"));
}

TEST(FitHints, SuggestsPenaltyOnlyIfUnused)
{
  FitSettings settings;
  EXPECT_TRUE(Names(palpate::HintForImplausible(settings, OptionWords), "--penalty auto"));
  settings.PenaltyKind = FitSettings::Penalty::Automatic;
  EXPECT_FALSE(Names(palpate::HintForImplausible(settings, OptionWords), "--penalty"));
}
} // namespace
} // namespace palpate::fit_hints_test
