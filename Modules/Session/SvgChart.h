#pragma once

#include "ChartMark.h"
#include "PalpateSessionModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A small chart as inline SVG: bars or a line over one pair of axes. Colours come from the page's
/// style sheet (classes "bar", "line", "marker", "axis", "grid"), so that it follows light and
/// dark.
class PALPATESESSION_EXPORT SvgChart
{
public:
  /// Of the picture, in its own units.
  static constexpr double Width = 390.0;
  static constexpr double Height = 240.0;

  /// Labels name quantity and unit.
  SvgChart(std::string horizontalLabel, std::string verticalLabel);

  /// Decades on the vertical axis; numbers that are not positive are left out.
  void SetLogarithmic(bool logarithmic) { this->IsLogarithmic = logarithmic; }
  /// Points (x, y); bars are `width` wide in the unit of x. Points that are not finite are left
  /// out.
  void SetBars(std::vector<std::pair<double, double>> points, double width);
  void SetLine(std::vector<std::pair<double, double>> points);
  /// A vertical rule with a word beside it.
  void SetMarker(double x, std::string text);

  /// What is to be drawn, in the order of drawing; nothing where there is no point to draw.
  std::vector<ChartMark> Marks() const;
  /// The whole <svg> element; empty where there is no point to draw.
  std::string Svg() const;

private:
  using Points = std::vector<std::pair<double, double>>;
  struct Frame;

  Points Drawable() const;
  Frame MakeFrame(const Points& points) const;
  void AddAxes(const Frame& frame, std::vector<ChartMark>& marks) const;
  void AddData(const Frame& frame, const Points& points, std::vector<ChartMark>& marks) const;
  void AddMarker(const Frame& frame, std::vector<ChartMark>& marks) const;

  std::string HorizontalLabel;
  std::string VerticalLabel;
  bool IsLogarithmic = false;
  Points Data;
  double BarWidth = 0.0; ///< 0 for a line
  bool HasMarker = false;
  double MarkerPlace = 0.0;
  std::string MarkerText;
};
} // namespace palpate
