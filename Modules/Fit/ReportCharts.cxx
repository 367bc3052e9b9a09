#include "ReportCharts.h"

#include "MeshConversion.h"
#include "MeshDistances.h"
#include "ReportPage.h"
#include "SvgChart.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>

namespace palpate
{
namespace
{
constexpr int BinCount = 40;

void AddSpectrum(ReportPage& page, const FitResult& result)
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
  page.Chart(chart, "Power spectrum: contribution of each degree to the " + what +
                        ", as root mean square over all directions.");
}

// Only of a fit that gives the residuals of all smaller ones.
void AddErrorByDegree(ReportPage& page, const FitResult& result)
{
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
  page.Chart(chart, "Error against degree: residual of the radii for every smaller model.");
}

void AddDistances(ReportPage& page, vtkPolyData* model)
{
  vtkDataArray* array = model ? model->GetPointData()->GetArray("DistanceToSurface") : nullptr;
  if (!array || array->GetNumberOfTuples() != model->GetNumberOfPoints())
  {
    return;
  }
  std::vector<double> distances;
  for (vtkIdType p = 0; p < array->GetNumberOfTuples(); ++p)
  {
    distances.push_back(array->GetComponent(p, 0));
  }
  SvgChart chart("signed distance from model to surface, mm",
                 "share of the model\xE2\x80\x99s area, %");
  chart.SetHistogram(distances, PointAreas(ToIndexedMesh(model)), BinCount);
  page.Chart(chart, "Distances: share of the model's area at each distance inside (negative) or "
                    "outside the surface of the mask.");
}
} // namespace

void ReportCharts(ReportPage& page, const FitResult& result)
{
  if (result.State == FitResult::Outcome::Fitted)
  {
    AddSpectrum(page, result);
    AddErrorByDegree(page, result);
    AddDistances(page, result.ModelSurface);
  }
}
} // namespace palpate
