#include "ComparisonCharts.h"

#include "AnatomicalView.h"
#include "DecimalText.h"
#include "HtmlText.h"
#include "ReportPage.h"
#include "SliceContour.h"
#include "SlicePlane.h"
#include "SvgChart.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Bins = 60;
constexpr int CurvePoints = 60;

std::string Histogram(const PairComparison& pair)
{
  const std::vector<double>& values = pair.Numbers.OneToOther.Samples.Values;
  const std::vector<double>& weights = pair.Numbers.OneToOther.Samples.Weights;
  const auto [low, high] = std::minmax_element(values.begin(), values.end());
  const double width = (*high - *low) / Bins;
  if (!(width > 1e-9))
  {
    return {};
  }
  SvgChart::Points bars;
  for (int bin = 0; bin < Bins; ++bin)
  {
    bars.emplace_back(*low + (bin + 0.5) * width, 0.0);
  }
  for (std::size_t i = 0; i < values.size(); ++i)
  {
    const int bin = std::min(Bins - 1, static_cast<int>((values[i] - *low) / width));
    bars[static_cast<std::size_t>(bin)].second += 100.0 * weights[i];
  }
  SvgChart chart("distance from the reference, mm", "share of the first surface, %");
  chart.SetBars(std::move(bars), width);
  return ReportFigure(chart.Svg(), "Distances: share of the first surface's area at each distance "
                                   "inside (negative) or outside the reference.");
}

std::string ToleranceCurve(const PairComparison& pair)
{
  const BodyComparison& numbers = pair.Numbers;
  const double end =
      std::max({1.0, 1.2 * numbers.Hausdorff95(),
                numbers.Tolerances.empty() ? 0.0 : numbers.Tolerances.back().Millimeters});
  std::vector<double> tolerances;
  for (int i = 0; i <= CurvePoints; ++i)
  {
    tolerances.push_back(end * i / CurvePoints);
  }
  const std::vector<double> dice = SurfaceDice(*pair.OneBody, numbers.OneToOther, *pair.OtherBody,
                                               numbers.OtherToOne, tolerances);
  SvgChart::Points line;
  for (std::size_t i = 0; i < dice.size(); ++i)
  {
    line.emplace_back(tolerances[i], dice[i]);
  }
  SvgChart chart("tolerance, mm", "normalised surface Dice");
  chart.SetLine(std::move(line));
  return ReportFigure(chart.Svg(), "Surface Dice: share of both surfaces' area that lies within a "
                                   "tolerance of the other one.");
}

// A plane through the middle of a box, as seen from a side.
SlicePlane PlaneThrough(const vtkBoundingBox& box, const char* name, ViewSide side)
{
  constexpr int Size = 340; // pixels
  const ViewFrame frame = FrameOf(side);
  Vector3 center;
  box.GetCenter(center.data());
  const double width = 1.1 * box.GetMaxLength();
  SlicePlane plane;
  plane.Name = name;
  plane.RightWorld = frame.RightWorld;
  plane.DownWorld = -frame.UpWorld;
  plane.PixelMillimeters = width / Size;
  plane.Width = Size;
  plane.Height = Size;
  plane.CornerWorld = center - 0.5 * width * (plane.RightWorld + plane.DownWorld);
  return plane;
}

std::string OutlinePath(const char* style, vtkPolyData* surface, const SlicePlane& plane)
{
  const std::string path = SurfaceContourPath(surface, plane);
  return path.empty() ? path : std::string("<path class=\"") + style + "\" d=\"" + path + "\"/>";
}

std::string OutlineFigure(const ComparisonMap& map, const SlicePlane& plane)
{
  const auto letter = [](double x, double y, const char* anchor, const Vector3& direction)
  {
    return "<text x=\"" + FixedText(x, 0) + "\" y=\"" + FixedText(y, 0) + "\" text-anchor=\"" +
           anchor + "\">" + OrientationLetters(direction) + "</text>";
  };
  const double size = plane.Width;
  const std::string side = std::to_string(plane.Width);
  return ReportFigure("<svg class=\"slice\" role=\"img\" viewBox=\"0 0 " + side + " " + side +
                          "\" aria-label=\"" + plane.Name + " outlines\">" +
                          OutlinePath("surface", map.Other(), plane) +
                          OutlinePath("model", map.One(), plane) +
                          letter(5.0, 0.5 * size + 5.0, "start", -plane.RightWorld) +
                          letter(size - 5.0, 0.5 * size + 5.0, "end", plane.RightWorld) +
                          letter(0.5 * size, 17.0, "middle", -plane.DownWorld) +
                          letter(0.5 * size, size - 6.0, "middle", plane.DownWorld) + "</svg>",
                      plane.Name);
}
} // namespace

std::string ComparisonCharts(const PairComparison& pair)
{
  return "<div class=\"charts\">\n" + Histogram(pair) + ToleranceCurve(pair) + "</div>\n";
}

std::string ComparisonSlices(const PairComparison& pair, const ComparisonMap& map)
{
  vtkBoundingBox box(map.One()->GetBounds());
  box.AddBounds(map.Other()->GetBounds());
  // Radiological convention: axial planes are seen from below.
  const std::array<SlicePlane, 3> planes{PlaneThrough(box, "Axial", ViewSide::Inferior),
                                         PlaneThrough(box, "Sagittal", ViewSide::Left),
                                         PlaneThrough(box, "Coronal", ViewSide::Anterior)};
  const auto [one, other] = TitlesOf(pair);
  std::string html = "<ul class=\"legend\"><li><i class=\"model\"></i>" + EscapeHtml(one) +
                     "</li><li><i class=\"surface\"></i>" + EscapeHtml(other) +
                     " (reference)</li></ul>\n<div class=\"slices\">\n";
  for (const SlicePlane& plane : planes)
  {
    html += OutlineFigure(map, plane);
  }
  return html + "</div>\n";
}
} // namespace palpate
