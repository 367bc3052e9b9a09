#include "SvgChart.h"

#include "DecimalText.h"
#include "HtmlText.h"
#include "RoundNumber.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
// The drawing area inside the chart.
constexpr double Left = 60.0;
constexpr double Right = 380.0;
constexpr double Top = 14.0;
constexpr double Bottom = 194.0;
constexpr int TickGoal = 6;

std::string Coordinate(double value)
{
  return FixedText(value, 1);
}

std::string LineSvg(const std::string& style, double x1, double y1, double x2, double y2)
{
  return "<line class=\"" + style + "\" x1=\"" + Coordinate(x1) + "\" y1=\"" + Coordinate(y1) +
         "\" x2=\"" + Coordinate(x2) + "\" y2=\"" + Coordinate(y2) + "\"/>";
}

std::string TextSvg(double x, double y, const char* anchor, const std::string& text)
{
  return "<text x=\"" + Coordinate(x) + "\" y=\"" + Coordinate(y) + "\" text-anchor=\"" + anchor +
         "\">" + EscapeHtml(text) + "</text>";
}

std::string CurveSvg(const SvgChart::Points& points)
{
  std::string path;
  for (const auto& [x, y] : points)
  {
    path += (path.empty() ? "" : " ") + Coordinate(x) + "," + Coordinate(y);
  }
  return "<polyline class=\"line\" points=\"" + path + "\"/>";
}

std::string DotSvg(const std::string& style, double x, double y, const std::string& text)
{
  return "<circle class=\"" + style + "\" r=\"2.6\" cx=\"" + Coordinate(x) + "\" cy=\"" +
         Coordinate(y) + "\"><title>" + EscapeHtml(text) + "</title></circle>";
}

std::string NumbersText(double x, double y)
{
  return SignificantText(x, 4) + ": " + SignificantText(y, 4);
}

// Whether a label at a position would not cover another.
bool HasRoom(const SvgChart::Points& labelled, double x, double y)
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

// Maps numbers to positions; a logarithmic range is in decades.
struct SvgChart::Axis
{
  double Low;
  double High;
  bool IsLogarithmic;
  double From;
  double To;

  double At(double value) const
  {
    const double place = this->IsLogarithmic ? std::log10(value) : value;
    return this->From + (place - this->Low) / (this->High - this->Low) * (this->To - this->From);
  }
  void RoundToDecades(double least, double most)
  {
    this->Low = std::floor(std::log10(least));
    this->High = std::max(this->Low + 1.0, std::ceil(std::log10(most)));
  }
  std::vector<double> Ticks() const
  {
    return this->IsLogarithmic ? this->Decades() : this->Steps();
  }

private:
  std::vector<double> Steps() const
  {
    std::vector<double> ticks;
    const double step = RoundNumberAbove((this->High - this->Low) / TickGoal);
    for (double k = std::ceil(this->Low / step - 1e-9); k * step <= this->High + 1e-9 * step;
         k += 1.0)
    {
      ticks.push_back(k * step + 0.0); // no negative zero
    }
    return ticks;
  }
  // With 2 and 5 times the powers of ten if there are few.
  std::vector<double> Decades() const
  {
    std::vector<double> ticks;
    const int decades = static_cast<int>(this->High - this->Low);
    const int step = std::max(1, (decades + TickGoal - 1) / TickGoal);
    for (int decade = 0; decade <= decades; decade += step)
    {
      const double power = std::pow(10.0, this->Low + decade);
      ticks.push_back(power);
      if (decades <= 2 && decade < decades)
      {
        ticks.insert(ticks.end(), {2.0 * power, 5.0 * power});
      }
    }
    return ticks;
  }
};

SvgChart::SvgChart(std::string horizontalLabel, std::string verticalLabel)
    : HorizontalLabel(std::move(horizontalLabel)), VerticalLabel(std::move(verticalLabel))
{
}

void SvgChart::SetLogarithmic(bool horizontal, bool vertical)
{
  this->IsHorizontalLogarithmic = horizontal;
  this->IsVerticalLogarithmic = vertical;
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

void SvgChart::SetHistogram(const std::vector<double>& values, const std::vector<double>& weights,
                            int bins)
{
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  double total = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (std::isfinite(values[i]))
    {
      low = std::min(low, values[i]);
      high = std::max(high, values[i]);
      total += weights[i];
    }
  }
  const double width = (high - low) / bins;
  if (!(width > 1e-9)) // only rounding
  {
    return;
  }
  Points bars;
  for (int bin = 0; bin < bins; ++bin)
  {
    bars.emplace_back(low + (bin + 0.5) * width, 0.0);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    if (std::isfinite(values[i]))
    {
      const int bin = std::min(bins - 1, static_cast<int>((values[i] - low) / width));
      bars[static_cast<std::size_t>(bin)].second += 100.0 * weights[i] / total;
    }
  }
  this->SetBars(std::move(bars), width);
}

void SvgChart::SetMarker(double x, std::string text)
{
  this->Marker = {true, x, std::move(text)};
}

void SvgChart::SetThreshold(double y, std::string text)
{
  this->Threshold = {true, y, std::move(text)};
}

bool SvgChart::CanDraw(double x, double y) const
{
  return std::isfinite(x) && std::isfinite(y) && (!this->IsHorizontalLogarithmic || x > 0.0) &&
         (!this->IsVerticalLogarithmic || y > 0.0);
}

SvgChart::Points SvgChart::Drawable(const Points& points) const
{
  Points drawable;
  std::copy_if(points.begin(), points.end(), std::back_inserter(drawable),
               [this](const auto& point) { return this->CanDraw(point.first, point.second); });
  return drawable;
}

SvgChart::Axis SvgChart::HorizontalAxis(const Points& points) const
{
  const auto [first, last] = std::minmax_element(points.begin(), points.end());
  Axis axis{first->first, last->first, this->IsHorizontalLogarithmic, Left, Right};
  if (axis.IsLogarithmic)
  {
    axis.RoundToDecades(axis.Low, axis.High);
    return axis;
  }
  const double side = axis.High > axis.Low || this->BarWidth > 0.0 ? 0.5 * this->BarWidth : 0.5;
  axis.Low -= side;
  axis.High += side;
  return axis;
}

SvgChart::Axis SvgChart::VerticalAxis(const Points& points) const
{
  const auto isLower = [](const auto& a, const auto& b) { return a.second < b.second; };
  const auto [lowest, highest] = std::minmax_element(points.begin(), points.end(), isLower);
  double least = lowest->second;
  double most = highest->second;
  if (this->Threshold.IsSet)
  {
    least = std::min(least, this->Threshold.Place);
    most = std::max(most, this->Threshold.Place);
  }
  Axis axis{0.0, 1.0, this->IsVerticalLogarithmic, Bottom, Top};
  if (axis.IsLogarithmic)
  {
    axis.RoundToDecades(least, most);
  }
  else if (most > 0.0)
  {
    const double step = RoundNumberAbove(most / TickGoal);
    axis.High = step * std::ceil(most / step);
  }
  return axis;
}

std::string SvgChart::Axes(const Axis& x, const Axis& y) const
{
  std::string svg;
  for (const double tick : y.Ticks())
  {
    svg += LineSvg("grid", Left, y.At(tick), Right, y.At(tick)) +
           TextSvg(Left - 6.0, y.At(tick) + 4.0, "end", SignificantText(tick, 4));
  }
  for (const double tick : x.Ticks())
  {
    svg += LineSvg("axis", x.At(tick), Bottom, x.At(tick), Bottom + 4.0) +
           TextSvg(x.At(tick), Bottom + 17.0, "middle", SignificantText(tick, 4));
  }
  return svg + LineSvg("axis", Left, Bottom, Right, Bottom) +
         TextSvg(0.5 * (Left + Right), Height - 8.0, "middle", this->HorizontalLabel) +
         "<text transform=\"translate(13 " + Coordinate(0.5 * (Top + Bottom)) +
         ") rotate(-90)\" text-anchor=\"middle\">" + EscapeHtml(this->VerticalLabel) + "</text>";
}

std::string SvgChart::Rules(const Axis& x, const Axis& y) const
{
  std::string svg;
  if (this->Threshold.IsSet)
  {
    const double place = y.At(this->Threshold.Place);
    svg += LineSvg("marker", Left, place, Right, place) +
           TextSvg(Right, place - 4.0, "end", this->Threshold.Text);
  }
  const double place = x.At(this->Marker.Place);
  if (this->Marker.IsSet && place >= Left && place <= Right)
  {
    const bool isRight = place > 0.5 * (Left + Right);
    svg += LineSvg("marker", place, Top, place, Bottom) +
           TextSvg(place + (isRight ? -5.0 : 5.0), Top + 10.0, isRight ? "end" : "start",
                   this->Marker.Text);
  }
  return svg;
}

std::string SvgChart::StairsSvg(const Axis& x, const Axis& y) const
{
  Points stairs;
  for (const auto& [right, up] : this->Drawable(this->Stairs))
  {
    if (!stairs.empty())
    {
      stairs.emplace_back(x.At(right), stairs.back().second);
    }
    stairs.emplace_back(x.At(right), y.At(up));
  }
  return stairs.size() > 1 ? CurveSvg(stairs) : std::string();
}

std::string SvgChart::Bars(const Axis& x, const Axis& y) const
{
  const double half = 0.41 * (x.At(this->BarWidth) - x.At(0.0));
  std::string svg;
  for (const auto& [right, up] : this->Drawable(this->Data))
  {
    svg += "<rect class=\"bar\" x=\"" + Coordinate(x.At(right) - half) + "\" y=\"" +
           Coordinate(y.At(up)) + "\" width=\"" + Coordinate(2.0 * half) + "\" height=\"" +
           Coordinate(std::max(0.0, Bottom - y.At(up))) + "\"><title>" +
           EscapeHtml(NumbersText(right, up)) + "</title></rect>";
  }
  return svg;
}

std::string SvgChart::Line(const Axis& x, const Axis& y) const
{
  constexpr std::size_t MostMarked = 100; // more marks would hide the line
  const Points points = this->Drawable(this->Data);
  Points places;
  std::string marks;
  for (const auto& [right, up] : points)
  {
    places.emplace_back(x.At(right), y.At(up));
    if (points.size() <= MostMarked)
    {
      marks += DotSvg("bar", x.At(right), y.At(up), NumbersText(right, up));
    }
  }
  return places.empty() ? std::string() : CurveSvg(places) + marks;
}

std::string SvgChart::DotsSvg(const Axis& x, const Axis& y) const
{
  std::string svg;
  Points labelled;
  for (const Dot& dot : this->Dots)
  {
    if (!this->CanDraw(dot.X, dot.Y))
    {
      continue;
    }
    const double right = x.At(dot.X);
    const double down = y.At(dot.Y);
    svg += DotSvg(dot.Style, right, down, dot.Text);
    if (!dot.Label.empty() && HasRoom(labelled, right, down))
    {
      svg += TextSvg(right + 4.0, down - 4.0, "start", dot.Label);
      labelled.emplace_back(right, down);
    }
  }
  return svg;
}

std::string SvgChart::Svg() const
{
  Points points = this->Data;
  for (const Dot& dot : this->Dots)
  {
    points.emplace_back(dot.X, dot.Y);
  }
  points = this->Drawable(points);
  if (points.empty())
  {
    return {};
  }
  const Axis x = this->HorizontalAxis(points);
  const Axis y = this->VerticalAxis(points);
  return "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + FixedText(Width, 0) + " " +
         FixedText(Height, 0) + "\" aria-label=\"" +
         EscapeHtml(this->VerticalLabel + " against " + this->HorizontalLabel) + "\">" +
         this->Axes(x, y) + this->StairsSvg(x, y) +
         (this->BarWidth > 0.0 ? this->Bars(x, y) : this->Line(x, y)) + this->DotsSvg(x, y) +
         this->Rules(x, y) + "</svg>\n";
}
} // namespace palpate
