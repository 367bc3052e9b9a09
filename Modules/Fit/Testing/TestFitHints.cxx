#include "FitHints.h"

#include <gtest/gtest.h>

namespace
{
using palpate::FitSettings;

bool Names(const std::string& hint, const char* option)
{
  return hint.find(option) != std::string::npos;
}

TEST(FitHints, SuggestsVisibleCentreOnlyIfUnused)
{
  FitSettings settings;
  for (const auto hint :
       {palpate::HintForHidden, palpate::HintForMisfit, palpate::HintForImplausible})
  {
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

TEST(FitHints, NamesDegreeOptionInUse)
{
  FitSettings settings;
  EXPECT_TRUE(Names(palpate::HintForMisfit(settings), "--degree"));
  EXPECT_TRUE(Names(palpate::OptionsOfFit(settings), "--degree"));
  settings.Tolerance = 0.5;
  EXPECT_TRUE(Names(palpate::HintForMisfit(settings), "--max-degree"));
  EXPECT_FALSE(Names(palpate::HintForMisfit(settings), "another --degree"));
  EXPECT_TRUE(Names(palpate::OptionsOfFit(settings), "--tolerance"));
}

TEST(FitHints, SuggestsPenaltyOnlyIfUnused)
{
  FitSettings settings;
  EXPECT_TRUE(Names(palpate::HintForImplausible(settings), "--penalty auto"));
  settings.PenaltyKind = FitSettings::Penalty::Automatic;
  EXPECT_FALSE(Names(palpate::HintForImplausible(settings), "--penalty"));
}
} // namespace
