#include "ScaleBar.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate::scale_bar_test
{
namespace
{
TEST(ScaleBar, LengthIsOneTwoOrFiveTimesAPowerOfTen)
{
  EXPECT_DOUBLE_EQ(ScaleBar::RoundLength(99.0), 50.0);
  EXPECT_DOUBLE_EQ(ScaleBar::RoundLength(100.0), 100.0);
  EXPECT_DOUBLE_EQ(ScaleBar::RoundLength(0.3), 0.2);
  EXPECT_DOUBLE_EQ(ScaleBar::RoundLength(5.0), 5.0);
  for (int step = 0; step < 150; ++step)
  {
    const double millimeters = 0.013 * std::pow(1.07, step);
    const double length = ScaleBar::RoundLength(millimeters);
    EXPECT_LE(length, millimeters * (1.0 + 1e-12));
    EXPECT_GT(length, 0.4 * millimeters - 1e-12); // the widest gap is from 2 to 5
  }
}

TEST(ScaleBar, BarIsSlightlyShorterThanAThirdOfTheView)
{
  ScaleBar bar;
  for (const double pixel : {0.01, 0.123, 0.5, 2.0})
  {
    bar.Update(pixel, 640, 400, 1.0);
    EXPECT_LT(bar.LengthMillimeters() / pixel, 640.0 / 3.0);
    EXPECT_GT(bar.LengthMillimeters() / pixel, 640.0 * 0.3 * 0.4 - 1e-9);
  }
}
} // namespace
} // namespace palpate::scale_bar_test
