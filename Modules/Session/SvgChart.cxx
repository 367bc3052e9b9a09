#include "SvgChart.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "RoundNumber.h"

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
constexpr int TickGoal = 6;

using Kind = ChartMark::Kind;
using Side = ChartMark::Side;

std::vector<double> LinearTicks(double low, double high)
{
  std::vector<double> ticks;
  const double step = RoundNumberAbove((high - low) / TickGoal);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
  {
    ticks.push_back(k * step + 0.0); // no negative zero
  }
  return ticks;
}

ChartMark Line(const std::string& style, double x1, double y1, double x2, double y2)
{
  return {Kind::Line, style, {{x1, y1}, {x2, y2}}, {}, Side::Start};
}

ChartMark Text(double x, double y, Side anchor, const std::string& text)
{
  return {Kind::Text, {}, {{x, y}}, text, anchor};
}
} // namespace

// Ranges of both axes; the vertical one in decades where it is logarithmic.
struct SvgChart::Frame
{
  double LowX;
  double HighX;
  double LowY;
  double HighY;
  bool IsLogarithmic;

  double X(double value) const
  {
    return Left + (value - this->LowX) / (this->HighX - this->LowX) * (Right - Left);
  }
  double Y(double value) const
  {
    const double place = this->IsLogarithmic ? std::log10(value) : value;
    return Bottom - (place - this->LowY) / (this->HighY - this->LowY) * (Bottom - Top);
  }
};

SvgChart::SvgChart(std::string horizontalLabel, std::string verticalLabel)
    : HorizontalLabel(std::move(horizontalLabel)), VerticalLabel(std::move(verticalLabel))
{
}

void SvgChart::SetBars(Points points, double width)
{
  this->Data = std::move(points);
  this->BarWidth = width;
}

void SvgChart::SetLine(Points points)
{
  this->Data = std::move(points);
  this->BarWidth = 0.0;
}

void SvgChart::SetMarker(double x, std::string text)
{
  this->HasMarker = true;
  this->MarkerPlace = x;
  this->MarkerText = std::move(text);
}

SvgChart::Points SvgChart::Drawable() const
{
  Points points;
  std::copy_if(this->Data.begin(), this->Data.end(), std::back_inserter(points),
               [this](const auto& point)
               {
                 return std::isfinite(point.first) && std::isfinite(point.second) &&
                        (!this->IsLogarithmic || point.second > 0.0);
               });
  return points;
}

SvgChart::Frame SvgChart::MakeFrame(const Points& points) const
{
  const auto [firstX, lastX] = std::minmax_element(points.begin(), points.end());
  const auto [lowest, highest] =
      std::minmax_element(points.begin(), points.end(),
                          [](const auto& a, const auto& b) { return a.second < b.second; });
  const double side = this->BarWidth > 0.0 ? 0.5 * this->BarWidth : 0.0;
  Frame frame{firstX->first - side, lastX->first + side, 0.0, 1.0, this->IsLogarithmic};
  if (!(frame.HighX > frame.LowX))
  {
    frame.LowX -= 0.5;
    frame.HighX += 0.5;
  }
  if (this->IsLogarithmic)
  {
    frame.LowY = std::floor(std::log10(lowest->second));
    frame.HighY = std::max(frame.LowY + 1.0, std::ceil(std::log10(highest->second)));
  }
  else if (highest->second > 0.0)
  {
    const double step = RoundNumberAbove(highest->second / TickGoal);
    frame.HighY = step * std::ceil(highest->second / step);
  }
  return frame;
}

void SvgChart::AddAxes(const Frame& frame, std::vector<ChartMark>& marks) const
{
  if (this->IsLogarithmic)
  {
    const double decades = frame.HighY - frame.LowY;
    const double step = std::max(1.0, std::ceil(decades / TickGoal));
    const int ticks = static_cast<int>((decades + 0.5) / step);
    for (int tick = 0; tick <= ticks; ++tick)
    {
      const double value = std::pow(10.0, frame.LowY + tick * step);
      marks.push_back(Line("grid", Left, frame.Y(value), Right, frame.Y(value)));
      marks.push_back(Text(Left - 6.0, frame.Y(value) + 4.0, Side::End, SignificantText(value, 3)));
    }
  }
  else
  {
    for (const double tick : LinearTicks(frame.LowY, frame.HighY))
    {
      marks.push_back(Line("grid", Left, frame.Y(tick), Right, frame.Y(tick)));
      marks.push_back(Text(Left - 6.0, frame.Y(tick) + 4.0, Side::End, SignificantText(tick, 4)));
    }
  }
  for (const double tick : LinearTicks(frame.LowX, frame.HighX))
  {
    marks.push_back(Line("axis", frame.X(tick), Bottom, frame.X(tick), Bottom + 4.0));
    marks.push_back(Text(frame.X(tick), Bottom + 17.0, Side::Middle, SignificantText(tick, 4)));
  }
  marks.push_back(Line("axis", Left, Bottom, Right, Bottom));
  marks.push_back(Text(0.5 * (Left + Right), Height - 8.0, Side::Middle, this->HorizontalLabel));
  marks.push_back(
      {Kind::UprightText, {}, {{13.0, 0.5 * (Top + Bottom)}}, this->VerticalLabel, Side::Middle});
}

void SvgChart::AddData(const Frame& frame, const Points& points,
                       std::vector<ChartMark>& marks) const
{
  const auto say = [](double x, double y)
  { return SignificantText(x, 4) + ": " + SignificantText(y, 4); };
  if (this->BarWidth > 0.0)
  {
    const double half = 0.41 * (frame.X(this->BarWidth) - frame.X(0.0));
    for (const auto& [x, y] : points)
    {
      marks.push_back({Kind::Bar,
                       "bar",
                       {{frame.X(x) - half, frame.Y(y)}, {frame.X(x) + half, Bottom}},
                       say(x, y),
                       Side::Start});
    }
    return;
  }
  constexpr std::size_t MostMarked = 100; // of more, the marks would hide the line
  ChartMark curve{Kind::Curve, "line", {}, {}, Side::Start};
  for (const auto& [x, y] : points)
  {
    curve.Points.emplace_back(frame.X(x), frame.Y(y));
  }
  marks.push_back(curve);
  for (std::size_t p = 0; points.size() <= MostMarked && p < points.size(); ++p)
  {
    marks.push_back(
        {Kind::Dot, "bar", {curve.Points[p]}, say(points[p].first, points[p].second), Side::Start});
  }
}

void SvgChart::AddMarker(const Frame& frame, std::vector<ChartMark>& marks) const
{
  if (!this->HasMarker || this->MarkerPlace < frame.LowX || this->MarkerPlace > frame.HighX)
  {
    return;
  }
  const double x = frame.X(this->MarkerPlace);
  const bool isRight = x > 0.5 * (Left + Right);
  marks.push_back(Line("marker", x, Top, x, Bottom));
  marks.push_back(Text(x + (isRight ? -5.0 : 5.0), Top + 10.0, isRight ? Side::End : Side::Start,
                       this->MarkerText));
}

std::vector<ChartMark> SvgChart::Marks() const
{
  std::vector<ChartMark> marks;
  const Points points = this->Drawable();
  if (!points.empty())
  {
    const Frame frame = this->MakeFrame(points);
    this->AddAxes(frame, marks);
    this->AddData(frame, points, marks);
    this->AddMarker(frame, marks);
  }
  return marks;
}

std::string SvgChart::Svg() const
{
  const std::vector<ChartMark> marks = this->Marks();
  if (marks.empty())
  {
    return {};
  }
  return "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + FixedText(Width, 0) + " " +
         FixedText(Height, 0) + "\" aria-label=\"" +
         EscapeHtml(this->VerticalLabel + " against " + this->HorizontalLabel) + "\">" +
         SvgOf(marks) + "</svg>\n";
}
} // namespace palpate
