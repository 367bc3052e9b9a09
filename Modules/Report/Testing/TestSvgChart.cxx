#include "SvgChart.h"

#include "MarkupCheck.h"

#include <cmath>
#include <gtest/gtest.h>
#include <limits>

namespace palpate::svg_chart_test
{
namespace
{
using Points = std::vector<std::pair<double, double>>;

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

// The centres of the circles, in their order.
Points Circles(const std::string& svg)
{
  const std::string circle = "<circle ";
  const auto number = [&svg](std::size_t at, const std::string& name)
  { return std::stod(svg.substr(svg.find(name, at) + name.size())); };
  Points centers;
  for (std::size_t at = svg.find(circle); at != std::string::npos; at = svg.find(circle, at + 1))
  {
    centers.emplace_back(number(at, " cx=\""), number(at, " cy=\""));
  }
  return centers;
}

TEST(SvgChart, BarHeightsAreProportional)
{
  SvgChart chart("x", "y");
  chart.SetBars({{0, 1.0}, {1, 2.0}, {2, 4.0}}, 1.0);
  const std::vector<double> heights = BarHeights(chart.Svg());
  ASSERT_EQ(heights.size(), 3U);
  // Coordinates are written with one digit.
  EXPECT_NEAR(heights[1], 2.0 * heights[0], 0.3);
  EXPECT_NEAR(heights[2], 4.0 * heights[0], 0.5);
}

TEST(SvgChart, EqualFactorsAreEqualStepsOnLogarithmicAxis)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(false, true);
  chart.SetBars({{0, 0.02}, {1, 0.2}, {2, 2.0}}, 1.0);
  const std::vector<double> heights = BarHeights(chart.Svg());
  ASSERT_EQ(heights.size(), 3U);
  EXPECT_NEAR(heights[2] - heights[1], heights[1] - heights[0], 0.3);
  EXPECT_GT(heights[1] - heights[0], 20.0);
}

TEST(SvgChart, OmitsUndrawableNumbers)
{
  const double nan = std::numeric_limits<double>::quiet_NaN();
  SvgChart chart("x", "y");
  chart.SetBars({{0, 1.0}, {1, nan}, {nan, 2.0}, {3, 0.0}}, 1.0);
  EXPECT_EQ(BarHeights(chart.Svg()).size(), 2U);
  chart.SetLogarithmic(false, true);
  EXPECT_EQ(BarHeights(chart.Svg()).size(), 1U);
}

TEST(SvgChart, NoPointsGiveEmptyChart)
{
  SvgChart chart("x", "y");
  EXPECT_EQ(chart.Svg(), "");
  chart.SetLine({{0, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(chart.Svg(), "");
}

TEST(SvgChart, IsWellFormedForAnyRange)
{
  for (const double scale : {1e-12, 1e-3, 1.0, 1e9})
  {
    for (const bool logarithmic : {false, true})
    {
      SvgChart chart("<x>", "a & b");
      chart.SetLogarithmic(false, logarithmic);
      chart.SetLine({{-3, scale}, {0, 2 * scale}, {5, 1000 * scale}});
      chart.SetMarker(0, "\"here\"");
      EXPECT_EQ(palpate::test::MarkupError(chart.Svg()), "") << scale;
      chart.SetBars({{2, scale}}, 1.0);
      EXPECT_EQ(palpate::test::MarkupError(chart.Svg()), "") << scale;
    }
  }
}

TEST(SvgChart, EqualFactorsAreEqualStepsOnTwoLogarithmicAxes)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(true, true);
  chart.SetDots(
      {{0.1, 2.0, "first", "", ""}, {1.0, 20.0, "first", "", ""}, {10.0, 200.0, "second", "", ""}});
  const Points dots = Circles(chart.Svg());
  ASSERT_EQ(dots.size(), 3U);
  // Coordinates are written with one digit.
  EXPECT_NEAR(dots[1].first - dots[0].first, dots[2].first - dots[1].first, 0.21);
  EXPECT_NEAR(dots[1].second - dots[0].second, dots[2].second - dots[1].second, 0.21);
  EXPECT_GT(dots[1].first, dots[0].first);
  EXPECT_LT(dots[1].second, dots[0].second) << "up";
}

TEST(SvgChart, OmitsDotsOutsideLogarithmicAxes)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(true, true);
  chart.SetDots({{0.0, 1.0, "first", "", ""},
                 {1.0, NAN, "first", "", ""},
                 {-1.0, 1.0, "first", "", ""},
                 {1.0, INFINITY, "first", "", ""}});
  EXPECT_EQ(chart.Svg(), "");
}

TEST(SvgChart, AxisIncludesThreshold)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(true, true);
  chart.SetDots({{1.0, 100.0, "first", "", ""}});
  chart.SetThreshold(0.01, "enough");
  const std::string svg = chart.Svg();
  const std::string rule = "<line class=\"marker\" x1=\"60.0\" y1=\"";
  ASSERT_NE(svg.find(rule), std::string::npos);
  const double y = std::stod(svg.substr(svg.find(rule) + rule.size()));
  EXPECT_GT(y, Circles(svg).front().second);
  EXPECT_LE(y, 194.0); // the horizontal axis
}

TEST(SvgChart, LabelsDoNotOverlap)
{
  SvgChart chart("x", "y");
  chart.SetLogarithmic(true, true);
  chart.SetDots({{1.0, 1.0, "first", "", "one"},
                 {1.001, 1.001, "first", "", "two"},
                 {10.0, 10.0, "first", "", "three"}});
  const std::string svg = chart.Svg();
  EXPECT_NE(svg.find(">one<"), std::string::npos);
  EXPECT_EQ(svg.find(">two<"), std::string::npos);
  EXPECT_NE(svg.find(">three<"), std::string::npos);
}

TEST(SvgChart, DotsAreWellFormedForAnyInput)
{
  for (const double least : {1e-12, 1.0, 1e9})
  {
    for (const double factor : {1.0, 1.5, 1e15})
    {
      SvgChart chart("<x>", "a & b");
      chart.SetLogarithmic(true, true);
      chart.SetDots({{least, least, "first faint", "\"quoted\" <tag>", "&"},
                     {factor * least, factor * least, "third", "", ""}});
      chart.SetStairs({{least, factor * least}, {factor * least, least}});
      chart.SetThreshold(least, "<b>");
      EXPECT_EQ(palpate::test::MarkupError(chart.Svg()), "") << least << ", " << factor;
    }
  }
}
} // namespace
} // namespace palpate::svg_chart_test
