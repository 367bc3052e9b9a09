#pragma once

#include "ChartMark.h"
#include "PalpateSessionModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A cloud of points over two axes in decades as inline SVG, with the line of those that are worth
/// choosing, and a threshold. Colours come from the page's style sheet.
class PALPATESESSION_EXPORT ScatterChart
{
public:
  struct Dot
  {
    double X = 0.0;
    double Y = 0.0;
    std::string Style; ///< "first", "second" or "third", and " faint" for one that stands back
    std::string Text;  ///< what it says when it is pointed at
    std::string Label; ///< beside it where there is room; empty for none
  };

  /// Labels name quantity and unit.
  ScatterChart(std::string horizontalLabel, std::string verticalLabel);

  /// Those that are not finite and positive are left out.
  void SetDots(std::vector<Dot> dots) { this->Dots = std::move(dots); }
  /// A line through these places, as stairs: what costs less than a place is not as good.
  void SetFront(std::vector<std::pair<double, double>> front) { this->Front = std::move(front); }
  /// A level rule with a word; it widens the axis so that it is seen.
  void SetThreshold(double y, std::string text);

  /// Nothing where there is no dot to draw.
  std::vector<ChartMark> Marks() const;
  /// The whole <svg> element; empty where there is no dot to draw.
  std::string Svg() const;

private:
  struct Frame;

  std::vector<Dot> Drawable() const;
  Frame MakeFrame(const std::vector<Dot>& dots) const;
  void AddAxes(const Frame& frame, std::vector<ChartMark>& marks) const;
  void AddFront(const Frame& frame, std::vector<ChartMark>& marks) const;

  std::string HorizontalLabel;
  std::string VerticalLabel;
  std::vector<Dot> Dots;
  std::vector<std::pair<double, double>> Front;
  double Threshold = 0.0; ///< 0 for none
  std::string ThresholdText;
};
} // namespace palpate
