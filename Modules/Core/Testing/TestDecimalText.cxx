#include "DecimalText.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

namespace palpate::decimal_text_test
{
namespace
{
template <typename Real>
bool SameBits(Real a, Real b)
{
  return a == b && std::signbit(a) == std::signbit(b);
}

TEST(DecimalText, EveryFiniteDoubleRoundTrips)
{
  std::mt19937_64 random(20240601);
  for (int i = 0; i < 100000; ++i)
  {
    const std::uint64_t bits = random();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (std::isfinite(value))
    {
      const auto back = ParseNumber(ExactText(value));
      ASSERT_TRUE(back && SameBits(*back, value)) << ExactText(value);
    }
  }
}

TEST(DecimalText, ExtremeDoublesRoundTrip)
{
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(),
                             Limits::max(), Limits::lowest(), std::nextafter(1.0, 2.0), 0.1})
  {
    const auto back = ParseNumber(ExactText(value));
    ASSERT_TRUE(back && SameBits(*back, value)) << ExactText(value);
  }
}

TEST(DecimalText, NeedsAtMostSeventeenDigits)
{
  EXPECT_EQ(ExactText(0.1), "0.1");
  EXPECT_EQ(ExactText(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(ExactText(0.1f), "0.1");
}

TEST(DecimalText, AcceptsBlanksAndPlusSign)
{
  EXPECT_EQ(ParseNumber(" +1.5e1\r\n"), 15.0);
  EXPECT_EQ(ParseInteger(" -3\t"), -3);
}

TEST(DecimalText, RejectsOtherText)
{
  for (const char* text :
       {"", " ", "nan", "inf", "-inf", "1e999", "1,5", "0x10", "1 2", "1.5mm", "+-1", "++1", "."})
  {
    EXPECT_FALSE(ParseNumber(text)) << text;
  }
  for (const char* text : {"", "1.0", "1e3", "99999999999", "+-1"})
  {
    EXPECT_FALSE(ParseInteger(text)) << text;
  }
}

TEST(DecimalText, WritesNonFiniteNumbersAsADash)
{
  const std::string dash = "\xE2\x80\x93";
  EXPECT_EQ(FixedText(std::numeric_limits<double>::quiet_NaN(), 2), dash);
  EXPECT_EQ(FixedText(-std::numeric_limits<double>::infinity(), 2), dash);
  EXPECT_EQ(SignificantText(std::numeric_limits<double>::quiet_NaN(), 2), dash);
}

TEST(DecimalText, WritesTheRequestedDigits)
{
  EXPECT_EQ(FixedText(3.14159, 2), "3.14");
  EXPECT_EQ(FixedText(-0.001, 2), "0.00");
  EXPECT_EQ(FixedText(-0.01, 2), "-0.01");
  EXPECT_EQ(FixedText(12345.6, 0), "12346");
  EXPECT_EQ(FixedText(std::numeric_limits<double>::max(), 1).size(), 309U + 2U);
  EXPECT_EQ(SignificantText(0.000123456, 3), "0.000123");
  EXPECT_EQ(SignificantText(5.0, 4), "5");
  EXPECT_EQ(SignificantText(1e7), "1e+07");
  EXPECT_EQ(SignificantText(4.294836225), "4.29484");
}

TEST(DecimalText, AgainstLimitKeepsRequestedDecimalsIfSufficient)
{
  EXPECT_EQ(TextAgainstLimit(0.7, 0.75, 2), "0.70");
  EXPECT_EQ(TextAgainstLimit(12.345, 10.0, 1), "12.3");
}

TEST(DecimalText, AgainstLimitAddsDigitsUntilDifferenceShows)
{
  EXPECT_EQ(TextAgainstLimit(0.98499, 0.985, 3), "0.98499");
  EXPECT_EQ(TextAgainstLimit(0.9999999, 1.0, 2), "0.9999999");
  EXPECT_EQ(TextAgainstLimit(10.04, 10.0, 1), "10.04");
  EXPECT_EQ(TextAgainstLimit(-0.0004, 0.0, 2), "-0.0004");
}

TEST(DecimalText, AgainstLimitSupportsSignificantDigits)
{
  EXPECT_EQ(SignificantAgainstLimit(0.61234, 0.5, 3), "0.612");
  EXPECT_EQ(SignificantAgainstLimit(0.50004, 0.5, 3), "0.50004");
  EXPECT_EQ(SignificantAgainstLimit(999999.0, 1e6, 3), "999999");
  EXPECT_EQ(SignificantAgainstLimit(1e8, 1e8, 3), "1e+08");
}

TEST(DecimalText, AgainstLimitWritesEqualValueExactly)
{
  EXPECT_EQ(TextAgainstLimit(0.985, 0.985, 1), "0.985");
  EXPECT_EQ(TextAgainstLimit(10.0, 10.0, 1), "10.0");
  EXPECT_EQ(std::stod(TextAgainstLimit(1.0 / 3.0, 1.0 / 3.0, 2)), 1.0 / 3.0);
}

TEST(DecimalText, CountsOneAndSeveral)
{
  EXPECT_EQ(CountText(1, "cavity", "cavities"), "1 cavity");
  EXPECT_EQ(CountText(0, "cavity", "cavities"), "0 cavities");
  EXPECT_EQ(CountText(5'000'000'000, "voxel", "voxels"), "5000000000 voxels");
}

TEST(DecimalText, AgainstLimitDistinguishesNeighbouringDoubles)
{
  for (const double limit : {1e-30, 0.1, 1.0, 1e22})
  {
    const double below = std::nextafter(limit, 0.0);
    EXPECT_LT(std::stod(TextAgainstLimit(below, limit, 2)), limit);
    EXPECT_GE(std::stod(TextAgainstLimit(limit, below, 2)), limit);
  }
}

TEST(DecimalText, AgainstLimitSupportsNonFiniteAndLargestNumbers)
{
  EXPECT_EQ(TextAgainstLimit(std::numeric_limits<double>::infinity(), 1.0, 2), "inf");
  EXPECT_EQ(TextAgainstLimit(std::nan(""), 1.0, 2), "nan");
  const double largest = std::numeric_limits<double>::max();
  EXPECT_EQ(std::stod(TextAgainstLimit(-largest, 1.0, 2)), -largest);
}
} // namespace
} // namespace palpate::decimal_text_test
