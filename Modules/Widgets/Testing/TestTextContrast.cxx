#include "TextContrast.h"

#include "RandomShapes.h"

#include <gtest/gtest.h>

namespace palpate::text_contrast_test
{
namespace
{
// The extremes of WCAG 2.1, and #767676, the lightest grey that it allows on white.
TEST(TextContrast, RatiosMatchWcag)
{
  EXPECT_NEAR(ContrastRatio(Qt::black, Qt::white), 21.0, 1e-9);
  EXPECT_NEAR(ContrastRatio(Qt::white, Qt::black), 21.0, 1e-9);
  EXPECT_NEAR(ContrastRatio(Qt::red, Qt::red), 1.0, 1e-9);
  EXPECT_GE(ContrastRatio(QColor("#767676"), Qt::white), LeastTextContrast);
  EXPECT_LT(ContrastRatio(QColor("#777777"), Qt::white), LeastTextContrast);
}

TEST(TextContrast, KeepsReadableColors)
{
  EXPECT_EQ(ReadableOn(Qt::white, QColor("#123456")).name(), "#123456");
}

TEST(TextContrast, MakesEveryColorReadableOnEveryBackground)
{
  test::Random random(7);
  for (int n = 0; n < 1000; ++n)
  {
    const auto color = [&random] { return QColor::fromRgb(static_cast<QRgb>(random())); };
    const QColor ground = color();
    EXPECT_GE(ContrastRatio(ground, ReadableOn(ground, color())), LeastTextContrast)
        << ground.name().toStdString();
  }
}
} // namespace
} // namespace palpate::text_contrast_test
