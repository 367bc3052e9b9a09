#include "ArrayColors.h"

#include <cstdlib>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::array_colors_test
{
namespace
{
using Color = std::array<std::uint8_t, 3>;

constexpr double NaN = std::numeric_limits<double>::quiet_NaN();

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

TEST(ArrayColors, EndsAndCentreMatchRdBu)
{
  const auto table = MakeArrayColors(-2.0, 2.0);
  // Two levels of 255: the constants are rounded to hundredths of CIELAB units.
  EXPECT_LE(LargestDifference(ColorOf(table, -2.0), Color{{33, 102, 172}}), 2);
  EXPECT_LE(LargestDifference(ColorOf(table, 0.0), Color{{247, 247, 247}}), 2);
  EXPECT_LE(LargestDifference(ColorOf(table, 2.0), Color{{178, 24, 43}}), 2);
}

TEST(ArrayColors, LightnessDecreasesToBothSides)
{
  const auto table = MakeArrayColors(-1.0, 1.0);
  for (int step = 0; step < 20; ++step)
  {
    const double number = 0.05 * step;
    EXPECT_GT(Luminance(ColorOf(table, number)), Luminance(ColorOf(table, number + 0.05)));
    EXPECT_GT(Luminance(ColorOf(table, -number)), Luminance(ColorOf(table, -number - 0.05)));
  }
}

TEST(ArrayColors, NumbersBeyondRangeAreClamped)
{
  const auto table = MakeArrayColors(-0.5, 0.5);
  EXPECT_EQ(ColorOf(table, 7.0), ColorOf(table, 0.5));
  EXPECT_EQ(ColorOf(table, -7.0), ColorOf(table, -0.5));
}

TEST(ArrayColors, NumbersThatAreNotFiniteAreGrey)
{
  const auto table = MakeArrayColors(-1.0, 1.0);
  EXPECT_EQ(ColorOf(table, NaN), (Color{{128, 128, 128}}));
  EXPECT_EQ(ColorOf(table, std::numeric_limits<double>::infinity()), (Color{{128, 128, 128}}));
}

TEST(ArrayColors, RoundsRangeUpToConvenientNumbers)
{
  for (const auto& [size, limit] : {std::pair(0.54, 0.6), std::pair(1.0, 1.0), std::pair(0.3, 0.3),
                                    std::pair(1.01, 1.5), std::pair(82.0, 100.0)})
  {
    const auto table = MakeArrayColors(-size, size);
    EXPECT_DOUBLE_EQ(table->GetRange()[0], -limit);
    EXPECT_DOUBLE_EQ(table->GetRange()[1], limit);
  }
}

TEST(ArrayColors, ZeroIsWhiteAndCentredForBothSigns)
{
  const auto table = MakeArrayColors(-0.3, 0.9);
  EXPECT_DOUBLE_EQ(table->GetRange()[0], -1.0);
  EXPECT_DOUBLE_EQ(table->GetRange()[1], 1.0);
  double color[3];
  table->GetColor(0.0, color);
  for (const double part : color)
  {
    EXPECT_NEAR(part, 247.0 / 255.0, 0.01); // the centre of the map
  }
}

TEST(ArrayColors, OneSignUsesWholeRange)
{
  EXPECT_EQ(MakeArrayColors(0.0, 0.9)->GetRange()[0], 0.0);
  EXPECT_EQ(MakeArrayColors(-0.9, 0.0)->GetRange()[1], 0.0);
}

TEST(ArrayColors, OwnArraysHaveUnit)
{
  EXPECT_EQ(palpate::ArrayTitle("DistanceToSurface"), "Distance to the surface, mm");
  EXPECT_EQ(palpate::ArrayTitle("Thickness"), "Thickness");
}
} // namespace
} // namespace palpate::array_colors_test
