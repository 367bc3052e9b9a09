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
  row.PositionRare = row.BeyondPositionRare = millimeters;
  row.NoticeableRare = row.BeyondNoticeableRare = noticeable;
  row.DirectionRare = row.BeyondDirectionRare = 10.0;
  row.UncertaintyMean = 0.0;
  row.JumpMost = row.IdealJumpMost = 0.1;
  row.CostSeconds = microseconds;
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

TEST(TradeAdvice, RecommendsTheCheapestWithoutNoticeableErrors)
{
  const TradeAdvice advice = AdviseOn(Rows, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_TRUE(advice.IsMet);
  EXPECT_TRUE(Has(advice.Message, "degree 8")) << advice.Message;
  EXPECT_TRUE(Has(advice.Message, "2 of 4 settings")) << "the last does not reach 1 kHz";
  EXPECT_TRUE(Has(advice.Message, "count as equal")) << advice.Message;
}

TEST(TradeAdvice, ErrorsWithinTheUncertaintyAreNotNoticeable)
{
  std::vector<TradeRow> rows{Row(4, 1.0, 0.6, 7.8), Row(8, 2.0, 0.01, 0.01)};
  rows[0].BeyondPositionRare = rows[0].BeyondNoticeableRare = rows[0].BeyondDirectionRare = 0.0;
  rows[0].UncertaintyMean = rows[1].UncertaintyMean = 0.4;
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 0U) << advice.Message;
  EXPECT_TRUE(advice.IsMet);
  EXPECT_TRUE(Has(advice.Message, "uncertainty of 0.4 mm")) << advice.Message;
}

TEST(TradeAdvice, ErrorsThatDifferByLessThanTheUncertaintyAreEqual)
{
  std::vector<TradeRow> rows{Row(4, 1.0, 0.7, 1.6), Row(8, 2.0, 0.2, 0.0)};
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 1U) << "of an exact reference";
  rows[0].UncertaintyMean = rows[1].UncertaintyMean = 1.1; // twice the standard deviation
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 0U);
  rows[0].Seizures = 1.0;
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 1U);
}

TEST(TradeAdvice, EqualErrorsAreDecidedByTheJump)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].JumpMost = 0.2; // 0.1 N more than the reference's: three just noticeable differences
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 2U);
  EXPECT_TRUE(Has(advice.Message, "jumps least")) << advice.Message;
  rows[1].JumpMost = 0.13; // less than one more
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 1U);
}

TEST(TradeAdvice, CostIncludesPreparing)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].CostSeconds = 40.0; // fitted for long, though its ticks are faster
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 2U);
  EXPECT_TRUE(Has(advice.Message, "costs least")) << advice.Message;
}

TEST(TradeAdvice, CostsThatDifferLittleLeaveTheSmallerError)
{
  std::vector<TradeRow> rows = Rows;
  rows[1].CostSeconds = rows[2].CostSeconds / 1.2; // times vary by as much
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 2U);
  rows[1].CostSeconds = rows[2].CostSeconds / 1.3;
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 1U);
}

TEST(TradeAdvice, NoticeableErrorsThatDifferByLessThanTheUncertaintyAreEqual)
{
  std::vector<TradeRow> rows{Row(4, 1.0, 1.5, 9.0), Row(8, 2.0, 1.2, 5.0), Row(12, 4.0, 1.1, 3.0)};
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 2U) << "of an exact reference";
  for (TradeRow& row : rows)
  {
    row.UncertaintyMean = 0.3;
  }
  const TradeAdvice advice = AdviseOn(rows, 1000.0);
  EXPECT_EQ(advice.Row, 1U);
  EXPECT_FALSE(advice.IsMet);
  EXPECT_TRUE(Has(advice.Message, "2 are the most accurate and count as equal")) << advice.Message;
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
  rows[1].BeyondPositionRare = NAN;
  EXPECT_EQ(AdviseOn(rows, 1000.0).Row, 2U);
}

TEST(TradeAdvice, ComparesYieldingStructuresByTheirForce)
{
  std::vector<TradeRow> rows = Rows;
  for (TradeRow& row : rows)
  {
    row.Yields = true;
    row.PositionRare = row.BeyondPositionRare = row.UncertaintyMean = NAN;
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
