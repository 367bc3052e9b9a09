#include "ReportCharts.h"

#include "HtmlText.h"
#include "MeshConversion.h"
#include "MeshDistances.h"
#include "ReportPage.h"
#include "SvgChart.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
constexpr int BinCount = 40;

std::string SpectrumChart(const FitResult& result)
{
  std::vector<std::pair<double, double>> points;
  const std::vector<double> power = PowerSpectrumOf(result.Model);
  // Degree 0 of a surface model is its place.
  for (std::size_t l = result.Radial() != nullptr ? 0 : 1; l < power.size(); ++l)
  {
    points.emplace_back(static_cast<double>(l), std::sqrt(power[l] / (4.0 * M_PI)));
  }
  const std::string what = result.Radial() != nullptr ? "radius" : "position";
  SvgChart chart("degree", "RMS share of the " + what + ", mm");
  chart.SetLogarithmic(false, true);
  chart.SetBars(std::move(points), 1.0);
  return ReportFigure(chart.Svg(), "Power spectrum: contribution of each degree to the " + what +
                                       ", as root mean square over all directions.");
}

// Only of a fit that gives the residuals of all smaller ones.
std::string DegreeChart(const FitResult& result)
{
  if (result.RmsByDegree.empty())
  {
    return {};
  }
  std::vector<std::pair<double, double>> points;
  for (std::size_t l = 0; l < result.RmsByDegree.size(); ++l)
  {
    points.emplace_back(static_cast<double>(l), result.RmsByDegree[l]);
  }
  SvgChart chart("degree", "RMS residual, mm");
  chart.SetLogarithmic(false, true);
  chart.SetLine(std::move(points));
  const int degree = DegreeOf(result.Model);
  chart.SetMarker(degree, "degree " + std::to_string(degree));
  return ReportFigure(chart.Svg(), "Error against degree: residual of the radii for every smaller "
                                   "model.");
}

std::string DistanceChart(vtkPolyData* model)
{
  vtkDataArray* distances = model ? model->GetPointData()->GetArray("DistanceToSurface") : nullptr;
  if (!distances || distances->GetNumberOfTuples() != model->GetNumberOfPoints())
  {
    return {};
  }
  double range[2];
  distances->GetFiniteRange(range);
  const double width = (range[1] - range[0]) / BinCount;
  if (!(width > 0.0))
  {
    return {};
  }
  const std::vector<double> areas = PointAreas(ToIndexedMesh(model));
  std::vector<std::pair<double, double>> bins;
  bins.reserve(BinCount);
  for (int b = 0; b < BinCount; ++b)
  {
    bins.emplace_back(range[0] + (b + 0.5) * width, 0.0);
  }
  double total = 0.0;
  for (std::size_t p = 0; p < areas.size(); ++p)
  {
    const double distance = distances->GetComponent(static_cast<vtkIdType>(p), 0);
    if (std::isfinite(distance))
    {
      const int bin = std::min(BinCount - 1, static_cast<int>((distance - range[0]) / width));
      bins[static_cast<std::size_t>(bin)].second += areas[p];
      total += areas[p];
    }
  }
  for (auto& bin : bins)
  {
    bin.second *= 100.0 / total;
  }
  SvgChart chart("signed distance from model to surface, mm",
                 "share of the model\xE2\x80\x99s area, %");
  chart.SetBars(std::move(bins), width);
  return ReportFigure(chart.Svg(), "Distances: share of the model's area at each distance inside "
                                   "(negative) or outside the surface of the mask.");
}
} // namespace

std::string ReportCharts(const FitResult& result)
{
  if (result.State != FitResult::Outcome::Fitted)
  {
    return {};
  }
  const std::string figures =
      SpectrumChart(result) + DegreeChart(result) + DistanceChart(result.ModelSurface);
  return "<div class=\"charts\">\n" + figures + "</div>\n";
}
} // namespace palpate
