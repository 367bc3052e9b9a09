#include "SvgChart.h"

#include "MarkupCheck.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

using palpate::SvgChart;
using Points = std::vector<std::pair<double, double>>;

namespace
{
// The heights of the rectangles of class "bar", in their order.
std::vector<double> BarHeights(const std::string& svg)
{
  const std::string bar = "<rect class=\"bar\"";
  const std::string height = " height=\"";
  std::vector<double> heights;
  for (std::size_t at = svg.find(bar); at != std::string::npos; at = svg.find(bar, at + 1))
  {
    heights.push_back(std::stod(svg.substr(svg.find(height, at) + height.size())));
  }
  return heights;
}
} // namespace

TEST(SvgChart, BarHeightsAreProportionalToTheNumbers)
{
  SvgChart chart("x", "y");
  chart.SetBars({{0, 1.0}, {1, 2.0}, {2, 4.0}}, 1.0);
  const std::vector<double> heights = BarHeights(chart.Svg());
  ASSERT_EQ(heights.size(), 3U);
  // Coordinates are written with one digit.
  EXPECT_NEAR(heights[1], 2.0 * heights[0], 0.3);
  EXPECT_NEAR(heights[2], 4.0 * heights[0], 0.5);
}

TEST(SvgChart, EqualFactorsAreEqualStepsOnALogarithmicAxis)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(true);
  chart.SetBars({{0, 0.02}, {1, 0.2}, {2, 2.0}}, 1.0);
  const std::vector<double> heights = BarHeights(chart.Svg());
  ASSERT_EQ(heights.size(), 3U);
  EXPECT_NEAR(heights[2] - heights[1], heights[1] - heights[0], 0.3);
  EXPECT_GT(heights[1] - heights[0], 20.0);
}

TEST(SvgChart, NumbersThatCannotBeDrawnAreLeftOut)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SvgChart chart("x", "y");
  chart.SetBars({{0, 1.0}, {1, nan}, {nan, 2.0}, {3, 0.0}}, 1.0);
  EXPECT_EQ(BarHeights(chart.Svg()).size(), 2U);
  chart.SetLogarithmic(true);
  EXPECT_EQ(BarHeights(chart.Svg()).size(), 1U);
}

TEST(SvgChart, NothingToDrawGivesNothing)
{
  SvgChart chart("x", "y");
  EXPECT_EQ(chart.Svg(), "");
  chart.SetLine({{0, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(chart.Svg(), "");
}

TEST(SvgChart, ItIsWellFormedForAnyRangeOfNumbers)
{
  for (const double scale : {1e-12, 1e-3, 1.0, 1e9})
  {
    for (const bool logarithmic : {false, true})
    {
      SvgChart chart("<x>", "a & b");
      chart.SetLogarithmic(logarithmic);
      chart.SetLine({{-3, scale}, {0, 2 * scale}, {5, 1000 * scale}});
      chart.SetMarker(0, "\"here\"");
      EXPECT_EQ(palpate::test::MarkupError(chart.Svg()), "") << scale;
      chart.SetBars({{2, scale}}, 1.0);
      EXPECT_EQ(palpate::test::MarkupError(chart.Svg()), "") << scale;
    }
  }
}
