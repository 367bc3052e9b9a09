#include "MaskOutlines.h"

#include <gtest/gtest.h>
#include <random>

namespace palpate::mask_outlines_test
{
namespace
{
constexpr std::size_t Many = 100000;

// How often outlines wind around a point.
int Winding(const std::vector<PixelOutline>& outlines, double x, double y)
{
  int winding = 0;
  for (const PixelOutline& outline : outlines)
  {
    for (std::size_t i = 0; i < outline.size(); ++i)
    {
      const Eigen::Vector2d& a = outline[i];
      const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
      if ((a[1] > y) != (b[1] > y) && x < a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]))
      {
        winding += a[1] > y ? 1 : -1;
      }
    }
  }
  return winding;
}

TEST(MaskOutlines, EncloseExactlyThePixelsOfTheValue)
{
  std::mt19937_64 random(11);
  for (int round = 0; round < 200; ++round)
  {
    const int columns = 1 + static_cast<int>(random() % 12);
    const int rows = 1 + static_cast<int>(random() % 12);
    const std::uint64_t others = 1 + random() % 6;
    std::vector<int> values(static_cast<std::size_t>(columns * rows));
    for (int& value : values)
    {
      value = random() % (others + 3) < 3 ? 7 : static_cast<int>(random() % 3);
    }
    const auto outlines = MaskOutlines(values, columns, 7, Many);
    ASSERT_TRUE(outlines);
    for (int row = 0; row < rows; ++row)
    {
      for (int column = 0; column < columns; ++column)
      {
        const bool isInside = values[static_cast<std::size_t>(row * columns + column)] == 7;
        // 0 or 1, so that no rule of filling differs.
        ASSERT_EQ(std::abs(Winding(*outlines, column, row)), isInside ? 1 : 0) << round;
      }
    }
  }
}

TEST(MaskOutlines, OneOutlineForEachPartWithItsHoles)
{
  // A ring with an island in its hole, and a pixel at its corner.
  const std::vector<int> values{1, 1, 1, 1, 1, 0, //
                                1, 0, 0, 0, 1, 0, //
                                1, 0, 1, 0, 1, 0, //
                                1, 0, 0, 0, 1, 0, //
                                1, 1, 1, 1, 1, 0, //
                                0, 0, 0, 0, 0, 1};
  const auto outlines = MaskOutlines(values, 6, 1, Many);
  ASSERT_TRUE(outlines);
  EXPECT_EQ(outlines->size(), 3U);
}

TEST(MaskOutlines, RectangleHasEightPoints)
{
  const auto outlines = MaskOutlines({3, 3, 3, 3, 3, 3, 3, 3}, 4, 3, Many);
  ASSERT_EQ(outlines->size(), 1U);
  EXPECT_EQ(outlines->front().size(), 8U); // corners are cut
}

TEST(MaskOutlines, StopsBeyondTheMostParts)
{
  const std::vector<int> values{1, 0, 1, 0, 1};
  EXPECT_TRUE(MaskOutlines(values, 5, 1, 3));
  EXPECT_FALSE(MaskOutlines(values, 5, 1, 2));
  EXPECT_TRUE(MaskOutlines(values, 5, 4, 0)->empty());
}
} // namespace
} // namespace palpate::mask_outlines_test
