#include "ScatterChart.h"

#include "MarkupCheck.h"

#include <cmath>
#include <gtest/gtest.h>

namespace palpate
{
namespace
{
std::vector<ChartMark> DotsOf(const ScatterChart& chart)
{
  std::vector<ChartMark> dots;
  for (const ChartMark& mark : chart.Marks())
  {
    if (mark.What == ChartMark::Kind::Dot)
    {
      dots.push_back(mark);
    }
  }
  return dots;
}

TEST(ScatterChart, EqualFactorsAreEqualStepsOnBothAxes)
{
  ScatterChart chart("x", "y");
  chart.SetDots(
      {{0.1, 2.0, "first", "", ""}, {1.0, 20.0, "first", "", ""}, {10.0, 200.0, "second", "", ""}});
  const std::vector<ChartMark> dots = DotsOf(chart);
  ASSERT_EQ(dots.size(), 3U);
  const auto at = [&dots](std::size_t n) { return dots[n].Points.front(); };
  EXPECT_NEAR(at(1).first - at(0).first, at(2).first - at(1).first, 1e-9);
  EXPECT_NEAR(at(1).second - at(0).second, at(2).second - at(1).second, 1e-9);
  EXPECT_GT(at(1).first, at(0).first);
  EXPECT_LT(at(1).second, at(0).second) << "up";
}

TEST(ScatterChart, WhatHasNoPlaceOnDecadesIsLeftOut)
{
  ScatterChart chart("x", "y");
  chart.SetDots({{0.0, 1.0, "first", "", ""},
                 {1.0, NAN, "first", "", ""},
                 {-1.0, 1.0, "first", "", ""},
                 {1.0, INFINITY, "first", "", ""}});
  EXPECT_TRUE(chart.Svg().empty());
}

TEST(ScatterChart, AThresholdIsAlwaysSeen)
{
  ScatterChart chart("x", "y");
  chart.SetDots({{1.0, 100.0, "first", "", ""}});
  chart.SetThreshold(0.01, "enough");
  for (const ChartMark& mark : chart.Marks())
  {
    for (const auto& [x, y] : mark.Points)
    {
      EXPECT_GE(x, 0.0);
      EXPECT_LE(x, 390.0);
      EXPECT_GE(y, 0.0);
      EXPECT_LE(y, 240.0);
    }
  }
}

TEST(ScatterChart, LabelsDoNotLieOverEachOther)
{
  ScatterChart chart("x", "y");
  chart.SetDots({{1.0, 1.0, "first", "", "one"},
                 {1.001, 1.001, "first", "", "two"},
                 {10.0, 10.0, "first", "", "three"}});
  const std::string svg = chart.Svg();
  EXPECT_NE(svg.find(">one<"), std::string::npos);
  EXPECT_EQ(svg.find(">two<"), std::string::npos);
  EXPECT_NE(svg.find(">three<"), std::string::npos);
}

TEST(ScatterChart, IsWellFormedForAnyRangeAndText)
{
  for (const double least : {1e-12, 1.0, 1e9})
  {
    for (const double factor : {1.0, 1.5, 1e15})
    {
      ScatterChart chart("<x>", "a & b");
      chart.SetDots({{least, least, "first faint", "\"quoted\" <tag>", "&"},
                     {factor * least, factor * least, "third", "", ""}});
      chart.SetFront({{least, factor * least}, {factor * least, least}});
      chart.SetThreshold(least, "<b>");
      EXPECT_EQ(test::MarkupError(chart.Svg()), "") << least << ", " << factor;
    }
  }
}
} // namespace
} // namespace palpate
