#include "ComparisonCharts.h"

#include "AnatomicalView.h"
#include "ReportPage.h"
#include "SixViews.h"
#include "SliceContour.h"
#include "SlicePlane.h"
#include "SvgChart.h"

#include "vtkBoundingBox.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace palpate
{
namespace
{
constexpr int Bins = 60;
constexpr int CurvePoints = 60;

void AddHistogram(ReportPage& page, const PairComparison& pair)
{
  SvgChart chart("distance from the reference, mm", "share of the first surface, %");
  chart.SetHistogram(pair.Numbers.OneToOther.Samples.Values,
                     pair.Numbers.OneToOther.Samples.Weights, Bins);
  page.Chart(chart, "Distances: share of the first surface's area at each distance inside "
                    "(negative) or outside the reference.");
}

void AddToleranceCurve(ReportPage& page, const PairComparison& pair)
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
  page.Chart(chart,
             "Surface Dice: share of both surfaces' area that lies within a tolerance of the "
             "other one.");
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

ReportFigure OutlineFigure(const ComparisonMap& map, const SlicePlane& plane)
{
  const std::string side = std::to_string(plane.Width);
  return {"<svg class=\"slice\" role=\"img\" viewBox=\"0 0 " + side + " " + side +
              "\" aria-label=\"" + plane.Name + " outlines\">" +
              OutlinePath("surface", map.Other(), plane) + OutlinePath("model", map.One(), plane) +
              SideLetters(plane.Width, plane.Height, plane.RightWorld, plane.DownWorld) + "</svg>",
          plane.Name};
}
} // namespace

void AddComparisonCharts(ReportPage& page, const PairComparison& pair)
{
  AddHistogram(page, pair);
  AddToleranceCurve(page, pair);
}

void AddComparisonSlices(ReportPage& page, const PairComparison& pair, const ComparisonMap& map)
{
  vtkBoundingBox box(map.One()->GetBounds());
  box.AddBounds(map.Other()->GetBounds());
  const auto [one, other] = TitlesOf(pair);
  page.Legend({{"model", one}, {"surface", other + " (reference)"}});
  // Radiological convention: axial planes are seen from below.
  for (const SlicePlane& plane : {PlaneThrough(box, "Axial", ViewSide::Inferior),
                                  PlaneThrough(box, "Sagittal", ViewSide::Left),
                                  PlaneThrough(box, "Coronal", ViewSide::Anterior)})
  {
    page.Figure("slices", OutlineFigure(map, plane));
  }
}
} // namespace palpate
