#include "DecimalText.h"

#include <cmath>
#include <cstring>
#include <gtest/gtest.h>
#include <limits>
#include <random>

using palpate::ExactText;
using palpate::ParseInteger;
using palpate::ParseNumber;

namespace
{
template <typename Real>
bool SameBits(Real a, Real b)
{
  return a == b && std::signbit(a) == std::signbit(b);
}
} // namespace

TEST(DecimalText, EveryFiniteDoubleComesBackToTheSameBits)
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

TEST(DecimalText, ExtremeDoublesComeBackToTheSameBits)
{
  using Limits = std::numeric_limits<double>;
  for (const double value : {0.0, -0.0, Limits::denorm_min(), -Limits::denorm_min(), Limits::min(),
                             Limits::max(), Limits::lowest(), std::nextafter(1.0, 2.0), 0.1})
  {
    const auto back = ParseNumber(ExactText(value));
    ASSERT_TRUE(back && SameBits(*back, value)) << ExactText(value);
  }
}

TEST(DecimalText, NeedsNoMoreThanSeventeenDigits)
{
  EXPECT_EQ(ExactText(0.1), "0.1");
  EXPECT_EQ(ExactText(1.0 / 3.0), "0.3333333333333333");
  EXPECT_EQ(ExactText(0.1f), "0.1");
}

TEST(DecimalText, BlanksAndPlusSignAreTaken)
{
  EXPECT_EQ(ParseNumber(" +1.5e1\r\n"), 15.0);
  EXPECT_EQ(ParseInteger(" -3\t"), -3);
}

TEST(DecimalText, AnythingElseIsNoNumber)
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
