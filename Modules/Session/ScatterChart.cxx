#include "ScatterChart.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "SvgChart.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// The drawing area inside the picture, in the SVG's own units.
constexpr double Left = 60.0;
constexpr double Right = 380.0;
constexpr double Top = 14.0;
constexpr double Bottom = 194.0;

using Kind = ChartMark::Kind;
using Side = ChartMark::Side;

bool IsOnDecades(double number)
{
  return std::isfinite(number) && number > 0.0;
}

ChartMark Line(const std::string& style, double x1, double y1, double x2, double y2)
{
  return {Kind::Line, style, {{x1, y1}, {x2, y2}}, {}, Side::Start};
}

ChartMark Text(double x, double y, Side anchor, const std::string& text)
{
  return {Kind::Text, {}, {{x, y}}, text, anchor};
}

// Powers of ten between two, at most some six; with 2 and 5 times them where there are few.
std::vector<double> Ticks(double low, double high)
{
  constexpr double Goal = 6.0;
  std::vector<double> ticks;
  const int step = std::max(1, static_cast<int>(std::ceil((high - low) / Goal)));
  const int last = static_cast<int>(std::floor(high));
  for (int decade = static_cast<int>(std::floor(low)); decade <= last; decade += step)
  {
    for (const double part : {1.0, 2.0, 5.0})
    {
      const double place = decade + std::log10(part);
      const bool isWanted = part == 1.0 || high - low <= 2.0;
      if (isWanted && place >= low - 1e-9 && place <= high + 1e-9)
      {
        ticks.push_back(part * std::pow(10.0, decade));
      }
    }
  }
  return ticks;
}
// Whether a label at a place would not lie over another.
bool HasRoom(const std::vector<std::pair<double, double>>& labelled, double x, double y)
{
  constexpr double Wide = 16.0;
  constexpr double High = 11.0;
  return std::none_of(labelled.begin(), labelled.end(),
                      [&](const auto& place) {
                        return std::abs(place.first - x) < Wide &&
                               std::abs(place.second - y) < High;
                      });
}
} // namespace

// Ranges of both axes, in decades.
struct ScatterChart::Frame
{
  double LowX;
  double HighX;
  double LowY;
  double HighY;

  double X(double value) const
  {
    return Left + (std::log10(value) - this->LowX) / (this->HighX - this->LowX) * (Right - Left);
  }
  double Y(double value) const
  {
    return Bottom - (std::log10(value) - this->LowY) / (this->HighY - this->LowY) * (Bottom - Top);
  }
};

ScatterChart::ScatterChart(std::string horizontalLabel, std::string verticalLabel)
    : HorizontalLabel(std::move(horizontalLabel)), VerticalLabel(std::move(verticalLabel))
{
}

void ScatterChart::SetThreshold(double y, std::string text)
{
  this->Threshold = y;
  this->ThresholdText = std::move(text);
}

std::vector<ScatterChart::Dot> ScatterChart::Drawable() const
{
  std::vector<Dot> dots;
  std::copy_if(this->Dots.begin(), this->Dots.end(), std::back_inserter(dots),
               [](const Dot& dot) { return IsOnDecades(dot.X) && IsOnDecades(dot.Y); });
  return dots;
}

ScatterChart::Frame ScatterChart::MakeFrame(const std::vector<Dot>& dots) const
{
  constexpr double Margin = 0.12; // decades, so that no dot lies on an axis
  const auto range = [&dots](double Dot::*member)
  {
    const auto [low, high] =
        std::minmax_element(dots.begin(), dots.end(),
                            [member](const Dot& a, const Dot& b) { return a.*member < b.*member; });
    return std::make_pair(std::log10((*low).*member) - Margin,
                          std::log10((*high).*member) + Margin);
  };
  const auto [lowX, highX] = range(&Dot::X);
  auto [lowY, highY] = range(&Dot::Y);
  if (this->Threshold > 0.0)
  {
    lowY = std::min(lowY, std::log10(this->Threshold) - Margin);
    highY = std::max(highY, std::log10(this->Threshold) + Margin);
  }
  return {lowX, highX, lowY, highY};
}

void ScatterChart::AddAxes(const Frame& frame, std::vector<ChartMark>& marks) const
{
  for (const double tick : Ticks(frame.LowY, frame.HighY))
  {
    marks.push_back(Line("grid", Left, frame.Y(tick), Right, frame.Y(tick)));
    marks.push_back(Text(Left - 6.0, frame.Y(tick) + 4.0, Side::End, SignificantText(tick, 3)));
  }
  for (const double tick : Ticks(frame.LowX, frame.HighX))
  {
    marks.push_back(Line("axis", frame.X(tick), Bottom, frame.X(tick), Bottom + 4.0));
    marks.push_back(Text(frame.X(tick), Bottom + 17.0, Side::Middle, SignificantText(tick, 3)));
  }
  marks.push_back(Line("axis", Left, Bottom, Right, Bottom));
  marks.push_back(
      Text(0.5 * (Left + Right), SvgChart::Height - 8.0, Side::Middle, this->HorizontalLabel));
  marks.push_back(
      {Kind::UprightText, {}, {{13.0, 0.5 * (Top + Bottom)}}, this->VerticalLabel, Side::Middle});
  if (this->Threshold > 0.0)
  {
    const double y = frame.Y(this->Threshold);
    marks.push_back(Line("marker", Left, y, Right, y));
    marks.push_back(Text(Right, y - 4.0, Side::End, this->ThresholdText));
  }
}

void ScatterChart::AddFront(const Frame& frame, std::vector<ChartMark>& marks) const
{
  ChartMark stairs{Kind::Curve, "line", {}, {}, Side::Start};
  for (const auto& [x, y] : this->Front)
  {
    if (IsOnDecades(x) && IsOnDecades(y))
    {
      if (!stairs.Points.empty())
      {
        stairs.Points.emplace_back(frame.X(x), stairs.Points.back().second);
      }
      stairs.Points.emplace_back(frame.X(x), frame.Y(y));
    }
  }
  if (stairs.Points.size() > 1)
  {
    marks.push_back(stairs);
  }
}

std::vector<ChartMark> ScatterChart::Marks() const
{
  std::vector<ChartMark> marks;
  const std::vector<Dot> dots = this->Drawable();
  if (dots.empty())
  {
    return marks;
  }
  const Frame frame = this->MakeFrame(dots);
  this->AddAxes(frame, marks);
  this->AddFront(frame, marks);
  std::vector<std::pair<double, double>> labelled;
  for (const Dot& dot : dots)
  {
    const double x = frame.X(dot.X);
    const double y = frame.Y(dot.Y);
    marks.push_back({Kind::Dot, dot.Style, {{x, y}}, dot.Text, Side::Start});
    if (!dot.Label.empty() && HasRoom(labelled, x, y))
    {
      marks.push_back(Text(x + 4.0, y - 4.0, Side::Start, dot.Label));
      labelled.emplace_back(x, y);
    }
  }
  return marks;
}

std::string ScatterChart::Svg() const
{
  const std::vector<ChartMark> marks = this->Marks();
  if (marks.empty())
  {
    return {};
  }
  return "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + FixedText(SvgChart::Width, 0) + " " +
         FixedText(SvgChart::Height, 0) + "\" aria-label=\"" +
         EscapeHtml(this->VerticalLabel + " against " + this->HorizontalLabel) + "\">" +
         SvgOf(marks) + "</svg>\n";
}
} // namespace palpate
