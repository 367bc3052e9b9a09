#include "DivergingColorMap.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

using palpate::DivergingColorMap;
using Color = std::array<std::uint8_t, 3>;

namespace
{
// Relative luminance is monotone in lightness; its weights are those of sRGB.
double Luminance(const Color& color)
{
  return 0.2126 * color[0] + 0.7152 * color[1] + 0.0722 * color[2];
}

int LargestDifference(const Color& a, const Color& b)
{
  int largest = 0;
  for (std::size_t c = 0; c < 3; ++c)
  {
    largest = std::max(largest, std::abs(a[c] - b[c]));
  }
  return largest;
}
} // namespace

TEST(DivergingColorMap, EndsAndCentreMatchRdBu)
{
  const DivergingColorMap map(2.0);
  // Two levels of 255: the constants are rounded to hundredths of CIELAB units.
  EXPECT_LE(LargestDifference(map.ColorOf(-2.0), Color{{33, 102, 172}}), 2);
  EXPECT_LE(LargestDifference(map.ColorOf(0.0), Color{{247, 247, 247}}), 2);
  EXPECT_LE(LargestDifference(map.ColorOf(2.0), Color{{178, 24, 43}}), 2);
}

TEST(DivergingColorMap, LightnessDecreasesToBothSides)
{
  const DivergingColorMap map(1.0);
  for (int step = 0; step < 20; ++step)
  {
    const double number = 0.05 * step;
    EXPECT_GT(Luminance(map.ColorOf(number)), Luminance(map.ColorOf(number + 0.05)));
    EXPECT_GT(Luminance(map.ColorOf(-number)), Luminance(map.ColorOf(-number - 0.05)));
  }
}

TEST(DivergingColorMap, NumbersBeyondLimitAreClamped)
{
  const DivergingColorMap map(0.5);
  EXPECT_EQ(map.ColorOf(7.0), map.ColorOf(0.5));
  EXPECT_EQ(map.ColorOf(-7.0), map.ColorOf(-0.5));
}

TEST(DivergingColorMap, NanIsGrey)
{
  EXPECT_EQ(DivergingColorMap(1.0).ColorOf(std::numeric_limits<double>::quiet_NaN()),
            (Color{{128, 128, 128}}));
}

TEST(DivergingColorMap, RoundsLimitsUpToConvenientNumbers)
{
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(0.54), 0.6);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(1.0), 1.0);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(0.3), 0.3);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(1.01), 1.5);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(82.0), 100.0);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(0.0), 1.0);
  EXPECT_DOUBLE_EQ(DivergingColorMap::RoundLimit(std::numeric_limits<double>::quiet_NaN()), 1.0);
}
