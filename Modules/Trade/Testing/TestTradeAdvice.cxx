#include "TradeAdvice.h"

#include <gtest/gtest.h>

namespace palpate::trade_advice_test
{
namespace
{
// A row for harmonics of a degree, with mean tick time (us) and 99 % errors.
TradeRow Row(int degree, double microseconds, double millimeters, double noticeable)
{
  TradeRow row;
  row.Setting.Structure.Representation = TouchRepresentation::Harmonics;
  row.Setting.Structure.Degree = degree;
  row.TickMean = 1e3 * microseconds;
  row.TickRare = 2e3 * microseconds;
  row.Rate = 1e9 / row.TickRare;
  row.PositionRare = millimeters;
  row.NoticeableRare = noticeable;
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

TEST(TradeAdvice, RecommendsTheFastestWithoutNoticeableErrors)
{
  const TradeAdvice advice = AdviseOn(Rows, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_TRUE(advice.IsMet);
  EXPECT_TRUE(Has(advice.Message, "degree 8")) << advice.Message;
  EXPECT_TRUE(Has(advice.Message, "fastest of 2")) << "the last does not reach 1 kHz";
}

TEST(TradeAdvice, RejectsSettingsWithSeizures)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].Seizures = 1.0;
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 2U);
}

TEST(TradeAdvice, RecommendsAmongTheMostAccurateIfAllAreNoticeable)
{
  const std::vector<TradeRow> rows{Row(4, 1.0, 0.5, 5.0), Row(8, 2.0, 0.2, 2.1),
                                   Row(12, 4.0, 0.2, 2.0)};
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_FALSE(advice.IsMet);
}

TEST(TradeAdvice, RecommendsTheFastestIfNoneReachesTheRate)
{
  const TradeAdvice advice = AdviseOn(Rows, 1e6);
  EXPECT_EQ(advice.Row, 0U);
  EXPECT_FALSE(advice.IsMet);
}

TEST(TradeAdvice, IgnoresNan)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].PositionRare = NAN;
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 2U);
}

TEST(TradeAdvice, ComparesYieldingStructuresByTheirForce)
{
  std::vector<TradeRow> rows = Rows;
  for (TradeRow& row : rows)
  {
    row.Yields = true;
    row.PositionRare = NAN;
  }
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_TRUE(advice.IsMet);
  EXPECT_FALSE(Has(advice.Message, " mm")) << advice.Message;
  EXPECT_TRUE(Has(advice.Message, "choose rigid, harmonics of degree 8")) << advice.Message;
}

TEST(TradeAdvice, RecommendsNothingWithoutRows)
{
  EXPECT_FALSE(AdviseOn({}, 1000.0).Row);
  TradeRow refused = Row(4, 1.0, 0.5, 5.0);
  refused.State = TradeRow::Outcome::Refused;
  EXPECT_FALSE(AdviseOn({refused}, 1000.0).IsMet);
}

} // namespace
} // namespace palpate::trade_advice_test
