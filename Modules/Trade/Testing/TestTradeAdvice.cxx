#include "TradeAdvice.h"

#include "InputError.h"

#include <gtest/gtest.h>

namespace palpate
{
namespace
{
// A harmonic row by its degree, with a mean tick (us) and 99 % errors.
TradeRow Row(int degree, double microseconds, double millimeters, double noticeable)
{
  TradeRow row;
  row.Setting.Representation = TouchRepresentation::Harmonics;
  row.Setting.Degree = degree;
  row.TickMean = 1e3 * microseconds;
  row.TickRare = 2e3 * microseconds;
  row.Rate = 1e9 / row.TickRare;
  row.PositionRare = millimeters;
  row.NoticeableRare = noticeable;
  row.ForceRare = 0.5 * millimeters;
  row.DirectionRare = 10.0;
  row.Seizures = 0.0;
  row.Bytes = 1e6;
  return row;
}

const std::vector<TradeRow> Rows{Row(4, 1.0, 0.5, 5.0), Row(8, 2.0, 0.2, 0.9),
                                 Row(12, 4.0, 0.1, 0.4), Row(24, 900.0, 0.01, 0.1)};

bool Has(const std::string& text, const std::string& part)
{
  return text.find(part) != std::string::npos;
}

TEST(TradeAdvice, WithoutNeedsIsTheCheapestThatNoHandNotices)
{
  const TradeAdvice advice = AdviseOn(Rows, std::nullopt, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_TRUE(advice.IsMet);
  EXPECT_TRUE(Has(advice.Sentence, "degree 8")) << advice.Sentence;
  EXPECT_TRUE(Has(advice.Sentence, "cheapest of 2")) << "the last does not reach 1 kHz";
}

TEST(TradeAdvice, ASettingThatSeizesIsNotAmongThose)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].Seizures = 1.0;
  EXPECT_EQ(AdviseOn(rows, std::nullopt, 1000.0).Row, 2U);
}

TEST(TradeAdvice, WhereAllAreNoticedItIsTheCheapestOfAboutTheTruest)
{
  const std::vector<TradeRow> rows{Row(4, 1.0, 0.5, 5.0), Row(8, 2.0, 0.2, 2.1),
                                   Row(12, 4.0, 0.2, 2.0)};
  const TradeAdvice advice = AdviseOn(rows, std::nullopt, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_FALSE(advice.IsMet);
}

TEST(TradeAdvice, WhereNoneKeepsTheRateItIsTheCheapest)
{
  const TradeAdvice advice = AdviseOn(Rows, std::nullopt, 1e6);
  EXPECT_EQ(advice.Row, 0U);
  EXPECT_FALSE(advice.IsMet);
}

TEST(TradeAdvice, NeedsChooseTheCheapestThatMeetsThemAll)
{
  EXPECT_EQ(AdviseOn(Rows, ParseNeeds("error=0.15"), 1000.0).Row, 2U);
  EXPECT_EQ(AdviseOn(Rows, ParseNeeds("rate=400000,error=1"), 1000.0).Row, 0U);
  EXPECT_TRUE(AdviseOn(Rows, ParseNeeds("rate=100,error=0.05"), 1000.0).IsMet)
      << "the servo's own rate is not needed where another is";
}

TEST(TradeAdvice, WhatMissesSaysByHowMuch)
{
  const TradeAdvice advice = AdviseOn(Rows, ParseNeeds("rate=100000,error=0.08"), 1000.0);
  EXPECT_FALSE(advice.IsMet);
  EXPECT_EQ(advice.Row, 2U);
  EXPECT_TRUE(Has(advice.Sentence, "none of 4")) << advice.Sentence;
  EXPECT_TRUE(Has(advice.Sentence, "0.02 mm")) << advice.Sentence;
  EXPECT_TRUE(Has(advice.Sentence, "0.1 instead of 0.08")) << advice.Sentence;
}

TEST(TradeAdvice, WhatIsNoNumberMeetsNothing)
{
  std::vector<TradeRow> rows = Rows;
  for (TradeRow& row : rows)
  {
    row.ForceRare = NAN;
  }
  EXPECT_FALSE(AdviseOn(rows, ParseNeeds("force=100"), 1000.0).IsMet);
  rows[0].PositionRare = NAN;
  EXPECT_NE(AdviseOn(rows, ParseNeeds("rate=1"), 1000.0).Row, 0U);
}

TEST(TradeAdvice, WithoutRowsNothingIsChosen)
{
  EXPECT_FALSE(AdviseOn({}, std::nullopt, 1000.0).Row);
  TradeRow refused = Row(4, 1.0, 0.5, 5.0);
  refused.State = TradeRow::Outcome::Refused;
  EXPECT_FALSE(AdviseOn({refused}, ParseNeeds("rate=1"), 1000.0).IsMet);
}

TEST(TradeAdvice, NeedsThatSayNothingAreRefused)
{
  for (const char* text :
       {"", "rate", "rate=", "rate=0", "rate=-5", "rate=nan", "rate=inf", "speed=3",
        "rate=1,rate=2", "rate=1,", "rate=1 000", "=3", "error=0.2mm"})
  {
    EXPECT_THROW(static_cast<void>(ParseNeeds(text)), InputError) << text;
  }
  const TradeNeeds needs = ParseNeeds("rate=1000,error=0.2,force=0.1,direction=18,memory=10");
  EXPECT_EQ(needs.Rate, 1000.0);
  EXPECT_EQ(needs.Memory, 10.0);
}
} // namespace
} // namespace palpate
