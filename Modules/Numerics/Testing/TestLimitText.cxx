#include "LimitText.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace
{
using palpate::SignificantAgainstLimit;
using palpate::TextAgainstLimit;

TEST(LimitText, KeepsRequestedDecimalsIfSufficient)
{
  EXPECT_EQ(TextAgainstLimit(0.7, 0.75, 2), "0.70");
  EXPECT_EQ(TextAgainstLimit(12.345, 10.0, 1), "12.3");
}

TEST(LimitText, AddsDigitsUntilDifferenceShows)
{
  EXPECT_EQ(TextAgainstLimit(0.98499, 0.985, 3), "0.98499");
  EXPECT_EQ(TextAgainstLimit(0.9999999, 1.0, 2), "0.9999999");
  EXPECT_EQ(TextAgainstLimit(10.04, 10.0, 1), "10.04");
  EXPECT_EQ(TextAgainstLimit(-0.0004, 0.0, 2), "-0.0004");
}

TEST(LimitText, SupportsSignificantDigits)
{
  EXPECT_EQ(SignificantAgainstLimit(0.61234, 0.5, 3), "0.612");
  EXPECT_EQ(SignificantAgainstLimit(0.50004, 0.5, 3), "0.50004");
  EXPECT_EQ(SignificantAgainstLimit(999999.0, 1e6, 3), "999999");
  EXPECT_EQ(SignificantAgainstLimit(1e8, 1e8, 3), "1e+08");
}

TEST(LimitText, WritesEqualValueExactly)
{
  EXPECT_EQ(TextAgainstLimit(0.985, 0.985, 1), "0.985");
  EXPECT_EQ(TextAgainstLimit(10.0, 10.0, 1), "10.0");
  EXPECT_EQ(std::stod(TextAgainstLimit(1.0 / 3.0, 1.0 / 3.0, 2)), 1.0 / 3.0);
}

TEST(LimitText, DistinguishesNeighbouringDoubles)
{
  for (const double limit : {1e-30, 0.1, 1.0, 1e22})
  {
    const double below = std::nextafter(limit, 0.0);
    EXPECT_LT(std::stod(TextAgainstLimit(below, limit, 2)), limit);
    EXPECT_GE(std::stod(TextAgainstLimit(limit, below, 2)), limit);
  }
}

TEST(LimitText, SupportsNonFiniteAndLargestNumbers)
{
  EXPECT_EQ(TextAgainstLimit(std::numeric_limits<double>::infinity(), 1.0, 2), "inf");
  EXPECT_EQ(TextAgainstLimit(std::nan(""), 1.0, 2), "nan");
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(std::stod(TextAgainstLimit(-largest, 1.0, 2)), -largest);
}
} // namespace
