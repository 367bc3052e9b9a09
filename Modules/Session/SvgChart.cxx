#include "SvgChart.h"

#include "HtmlText.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// The drawing area inside the picture, in the SVG's own units.
constexpr double Width = 390.0;
constexpr double Height = 240.0;
constexpr double Left = 60.0;
constexpr double Right = 380.0;
constexpr double Top = 14.0;
constexpr double Bottom = 194.0;
constexpr int TickGoal = 6;

std::string Coordinate(double value)
{
  return FixedText(value, 1);
}

// The step 1, 2 or 5 times a power of ten that cuts `span` into about TickGoal parts.
double NiceStep(double span)
{
  const double raw = span / TickGoal;
  const double decade = std::pow(10.0, std::floor(std::log10(raw)));
  const double mantissa = raw / decade;
  return decade * (mantissa <= 1.0 ? 1.0 : mantissa <= 2.0 ? 2.0 : mantissa <= 5.0 ? 5.0 : 10.0);
}

std::vector<double> LinearTicks(double low, double high)
{
  std::vector<double> ticks;
  const double step = NiceStep(high - low);
  for (double k = std::ceil(low / step - 1e-9); k * step <= high + 1e-9 * step; k += 1.0)
  {
    ticks.push_back(k * step + 0.0); // no negative zero
  }
  return ticks;
}

std::string LineElement(const std::string& style, double x1, double y1, double x2, double y2)
{
  return "<line class=\"" + style + "\" x1=\"" + Coordinate(x1) + "\" y1=\"" + Coordinate(y1) +
         "\" x2=\"" + Coordinate(x2) + "\" y2=\"" + Coordinate(y2) + "\"/>";
}

std::string TextElement(double x, double y, const std::string& anchor, const std::string& text)
{
  return "<text x=\"" + Coordinate(x) + "\" y=\"" + Coordinate(y) + "\" text-anchor=\"" + anchor +
         "\">" + EscapeHtml(text) + "</text>";
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
    const double step = NiceStep(highest->second);
    frame.HighY = step * std::ceil(highest->second / step);
  }
  return frame;
}

std::string SvgChart::Axes(const Frame& frame) const
{
  std::string svg;
  if (this->IsLogarithmic)
  {
    const double decades = frame.HighY - frame.LowY;
    const double step = std::max(1.0, std::ceil(decades / TickGoal));
    const int ticks = static_cast<int>((decades + 0.5) / step);
    for (int tick = 0; tick <= ticks; ++tick)
    {
      const double value = std::pow(10.0, frame.LowY + tick * step);
      svg += LineElement("grid", Left, frame.Y(value), Right, frame.Y(value));
      svg += TextElement(Left - 6.0, frame.Y(value) + 4.0, "end", SignificantText(value, 3));
    }
  }
  else
  {
    for (const double tick : LinearTicks(frame.LowY, frame.HighY))
    {
      svg += LineElement("grid", Left, frame.Y(tick), Right, frame.Y(tick));
      svg += TextElement(Left - 6.0, frame.Y(tick) + 4.0, "end", SignificantText(tick, 4));
    }
  }
  for (const double tick : LinearTicks(frame.LowX, frame.HighX))
  {
    svg += LineElement("axis", frame.X(tick), Bottom, frame.X(tick), Bottom + 4.0);
    svg += TextElement(frame.X(tick), Bottom + 17.0, "middle", SignificantText(tick, 4));
  }
  svg += LineElement("axis", Left, Bottom, Right, Bottom);
  svg += TextElement(0.5 * (Left + Right), Height - 8.0, "middle", this->HorizontalLabel);
  const double middle = 0.5 * (Top + Bottom);
  svg += "<text transform=\"translate(13 " + Coordinate(middle) +
         ") rotate(-90)\" text-anchor=\"middle\">" + EscapeHtml(this->VerticalLabel) + "</text>";
  return svg;
}

std::string SvgChart::Marks(const Frame& frame, const Points& points) const
{
  std::string svg;
  if (this->BarWidth > 0.0)
  {
    const double width = 0.82 * (frame.X(this->BarWidth) - frame.X(0.0));
    for (const auto& [x, y] : points)
    {
      const double top = frame.Y(y);
      svg += "<rect class=\"bar\" x=\"" + Coordinate(frame.X(x) - 0.5 * width) + "\" y=\"" +
             Coordinate(top) + "\" width=\"" + Coordinate(width) + "\" height=\"" +
             Coordinate(std::max(0.0, Bottom - top)) + "\"><title>" +
             EscapeHtml(SignificantText(x, 4) + ": " + SignificantText(y, 4)) + "</title></rect>";
    }
    return svg;
  }
  constexpr std::size_t MostMarked = 100; // of more, the marks would hide the line
  std::string path;
  for (const auto& [x, y] : points)
  {
    path += (path.empty() ? "" : " ") + Coordinate(frame.X(x)) + "," + Coordinate(frame.Y(y));
    if (points.size() > MostMarked)
    {
      continue;
    }
    svg += "<circle class=\"bar\" r=\"2.6\" cx=\"" + Coordinate(frame.X(x)) + "\" cy=\"" +
           Coordinate(frame.Y(y)) + "\"><title>" +
           EscapeHtml(SignificantText(x, 4) + ": " + SignificantText(y, 4)) + "</title></circle>";
  }
  return "<polyline class=\"line\" points=\"" + path + "\"/>" + svg;
}

std::string SvgChart::Marker(const Frame& frame) const
{
  if (!this->HasMarker || this->MarkerPlace < frame.LowX || this->MarkerPlace > frame.HighX)
  {
    return {};
  }
  const double x = frame.X(this->MarkerPlace);
  const bool isRight = x > 0.5 * (Left + Right);
  return LineElement("marker", x, Top, x, Bottom) +
         TextElement(x + (isRight ? -5.0 : 5.0), Top + 10.0, isRight ? "end" : "start",
                     this->MarkerText);
}

std::string SvgChart::Svg() const
{
  const Points points = this->Drawable();
  if (points.empty())
  {
    return {};
  }
  const Frame frame = this->MakeFrame(points);
  return "<svg class=\"chart\" role=\"img\" viewBox=\"0 0 " + FixedText(Width, 0) + " " +
         FixedText(Height, 0) + "\" aria-label=\"" +
         EscapeHtml(this->VerticalLabel + " against " + this->HorizontalLabel) + "\">" +
         this->Axes(frame) + this->Marks(frame, points) + this->Marker(frame) + "</svg>\n";
}
} // namespace palpate
