#include "StripChart.h"
#include "WidgetTest.h"

#include <QImage>

#include <cmath>
#include <limits>

namespace palpate::strip_chart_test
{
namespace
{
class StripChartTest : public test::WidgetTest
{
protected:
  // Number of visible pixels in the curve's colour, some red.
  static int InkOf(StripChart& chart)
  {
    const QImage image = chart.grab().toImage();
    int ink = 0;
    for (int y = 0; y < image.height(); ++y)
    {
      for (int x = 0; x < image.width(); ++x)
      {
        const QColor color = image.pixelColor(x, y);
        ink += color.red() > color.green() + 100 && color.red() > color.blue() + 100 ? 1 : 0;
      }
    }
    return ink;
  }
};

TEST_F(StripChartTest, ShowsSinglePeakAmongThousands)
{
  StripChart chart("Force", "N", Qt::red, nullptr);
  chart.resize(200, 100);
  for (int tick = 0; tick < 5000; ++tick)
  {
    chart.Add(1e-3 * tick, tick == 2345 ? 4.0 : 0.0);
  }
  // 4 of 5 N over some 80 pixels.
  EXPECT_EQ(chart.Largest(), 4.0);
  EXPECT_GT(InkOf(chart), 196 + 50);
}

TEST_F(StripChartTest, DiscardsOldValues)
{
  StripChart chart("Force", "N", Qt::red, nullptr);
  chart.Add(0.0, 100.0);
  for (int tick = 0; tick < 60000; ++tick)
  {
    chart.Add(1e-3 * tick, 1.0);
  }
  EXPECT_EQ(chart.Largest(), 1.0);
  // 5 s at 1 kHz, and at most as much again.
  EXPECT_LE(chart.Count(), 10002U);
}

TEST_F(StripChartTest, IgnoresNan)
{
  StripChart chart("Force", "N", Qt::red, nullptr);
  chart.resize(200, 100);
  chart.Add(0.0, std::numeric_limits<double>::quiet_NaN());
  chart.Add(1.0, std::numeric_limits<double>::infinity());
  EXPECT_EQ(InkOf(chart), 0);
  chart.Add(2.0, 1.0);
  EXPECT_GT(InkOf(chart), 0);
}

TEST_F(StripChartTest, EarlierTimeRestartsCurve)
{
  StripChart chart("Force", "N", Qt::red, nullptr);
  chart.Add(100.0, 5.0);
  chart.Add(1.0, 2.0);
  EXPECT_EQ(chart.Count(), 1U);
}
} // namespace
} // namespace palpate::strip_chart_test
