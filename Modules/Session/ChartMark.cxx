#include "ChartMark.h"

#include "DecimalText.h"
#include "HtmlText.h"

#include <algorithm>
#include <array>

namespace palpate
{
namespace
{
std::string Coordinate(double value)
{
  return FixedText(value, 1);
}

std::string TextSvg(const ChartMark& mark)
{
  constexpr std::array<const char*, 3> Anchors{"start", "middle", "end"};
  const auto [x, y] = mark.Points.front();
  const bool isUpright = mark.What == ChartMark::Kind::UprightText;
  const std::string place =
      isUpright ? "transform=\"translate(" + Coordinate(x) + " " + Coordinate(y) + ") rotate(-90)\""
                : "x=\"" + Coordinate(x) + "\" y=\"" + Coordinate(y) + "\"";
  return "<text " + place + " text-anchor=\"" + Anchors.at(static_cast<std::size_t>(mark.Anchor)) +
         "\">" + EscapeHtml(mark.Text) + "</text>";
}

std::string LineSvg(const ChartMark& mark)
{
  return "<line class=\"" + mark.Style + "\" x1=\"" + Coordinate(mark.Points[0].first) +
         "\" y1=\"" + Coordinate(mark.Points[0].second) + "\" x2=\"" +
         Coordinate(mark.Points[1].first) + "\" y2=\"" + Coordinate(mark.Points[1].second) + "\"/>";
}

std::string CurveSvg(const ChartMark& mark)
{
  std::string path;
  for (const auto& [x, y] : mark.Points)
  {
    path += (path.empty() ? "" : " ") + Coordinate(x) + "," + Coordinate(y);
  }
  return "<polyline class=\"" + mark.Style + "\" points=\"" + path + "\"/>";
}

std::string BarSvg(const ChartMark& mark)
{
  const auto [left, top] = mark.Points[0];
  const auto [right, bottom] = mark.Points[1];
  return "<rect class=\"" + mark.Style + "\" x=\"" + Coordinate(left) + "\" y=\"" +
         Coordinate(top) + "\" width=\"" + Coordinate(right - left) + "\" height=\"" +
         Coordinate(std::max(0.0, bottom - top)) + "\"><title>" + EscapeHtml(mark.Text) +
         "</title></rect>";
}

std::string DotSvg(const ChartMark& mark)
{
  return "<circle class=\"" + mark.Style + "\" r=\"" + Coordinate(ChartDotRadius) + "\" cx=\"" +
         Coordinate(mark.Points.front().first) + "\" cy=\"" +
         Coordinate(mark.Points.front().second) + "\"><title>" + EscapeHtml(mark.Text) +
         "</title></circle>";
}

std::string SvgOf(const ChartMark& mark)
{
  switch (mark.What)
  {
  case ChartMark::Kind::Line:
    return LineSvg(mark);
  case ChartMark::Kind::Curve:
    return CurveSvg(mark);
  case ChartMark::Kind::Bar:
    return BarSvg(mark);
  case ChartMark::Kind::Dot:
    return DotSvg(mark);
  case ChartMark::Kind::Text:
  case ChartMark::Kind::UprightText:
    break;
  }
  return TextSvg(mark);
}
} // namespace

std::string SvgOf(const std::vector<ChartMark>& marks)
{
  std::string svg;
  for (const ChartMark& mark : marks)
  {
    svg += SvgOf(mark);
  }
  return svg;
}

std::vector<ChartMark> Shifted(std::vector<ChartMark> marks, double right, double down)
{
  for (ChartMark& mark : marks)
  {
    for (auto& [x, y] : mark.Points)
    {
      x += right;
      y += down;
    }
  }
  return marks;
}
} // namespace palpate
