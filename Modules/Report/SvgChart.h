#pragma once

#include "PalpateReportModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A small chart as inline SVG: bars, a line, or dots over one pair of axes, each linear or
/// logarithmic. Colours come from the page's style sheet (classes "bar", "line", "marker", "axis",
/// "grid", and those of dots), so that they follow light and dark.
class PALPATEREPORT_EXPORT SvgChart
{
public:
  using Points = std::vector<std::pair<double, double>>;
  struct Dot
  {
    double X = 0.0;
    double Y = 0.0;
    std::string Style; ///< a class, e.g. "first", and " faint" to draw it paler
    std::string Text;  ///< tool tip
    std::string Label; ///< next to the dot if there is space; empty for none
  };

  ///@{ Size in the chart's own units.
  static constexpr double Width = 390.0;
  static constexpr double Height = 240.0;
  ///@}

  /// Labels name quantity and unit.
  SvgChart(std::string horizontalLabel, std::string verticalLabel);

  /// Numbers that are not finite, or not positive on a logarithmic axis, are omitted.
  void SetLogarithmic(bool horizontal, bool vertical);
  /// Bars are `width` wide in the unit of x, which is linear.
  void SetBars(Points points, double width);
  void SetLine(Points points);
  /// Bars of the share (%) of the weights in each of `bins` equal intervals of the finite values;
  /// none if these are equal.
  void SetHistogram(const std::vector<double>& values, const std::vector<double>& weights,
                    int bins);
  void SetDots(std::vector<Dot> dots) { this->Dots = std::move(dots); }
  /// A staircase line through these points, e.g. a Pareto front.
  void SetStairs(Points points) { this->Stairs = std::move(points); }
  /// A vertical rule with a label; omitted outside the axis range.
  void SetMarker(double x, std::string text);
  /// A horizontal rule with a label; extends the axis range to include it.
  void SetThreshold(double y, std::string text);

  /// The whole `<svg>` element; empty if there is no point to draw.
  std::string Svg() const;

private:
  struct Axis;
  struct Rule
  {
    bool IsSet = false;
    double Place = 0.0;
    std::string Text;
  };

  bool CanDraw(double x, double y) const;
  Points Drawable(const Points& points) const;
  Axis HorizontalAxis(const Points& points) const;
  Axis VerticalAxis(const Points& points) const;
  std::string Axes(const Axis& x, const Axis& y) const;
  std::string Rules(const Axis& x, const Axis& y) const;
  std::string StairsSvg(const Axis& x, const Axis& y) const;
  std::string Bars(const Axis& x, const Axis& y) const;
  std::string Line(const Axis& x, const Axis& y) const;
  std::string DotsSvg(const Axis& x, const Axis& y) const;

  std::string HorizontalLabel;
  std::string VerticalLabel;
  bool IsHorizontalLogarithmic = false;
  bool IsVerticalLogarithmic = false;
  Points Data;
  double BarWidth = 0.0; ///< 0 for a line
  std::vector<Dot> Dots;
  Points Stairs;
  Rule Marker;
  Rule Threshold;
};
} // namespace palpate
