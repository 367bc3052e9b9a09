#include "CohortQualityFiles.h"

#include "AnatomicalView.h"
#include "CsvText.h"
#include "DecimalText.h"
#include "MappedMean.h"
#include "SurfaceFile.h"
#include "WholeFile.h"

#include <algorithm>

namespace palpate
{
namespace
{
std::string QualityTable(const ShapeModelQuality& quality)
{
  std::string text =
      CsvLine({"modes", "compactness_mm2", "compactness_se_mm2", "explained", "generalisation_mm",
               "generalisation_se_mm", "specificity_mm", "specificity_se_mm"});
  const Eigen::Index last = quality.Compactness.Values.size() - 1;
  const double total = last > 0 ? quality.Compactness.Values[last] : 1.0;
  for (Eigen::Index k = 0; k <= last; ++k)
  {
    text += CsvLine({std::to_string(k), ExactText(quality.Compactness.Values[k]),
                     ExactText(quality.Compactness.StandardErrors[k]),
                     ExactText(quality.Compactness.Values[k] / total),
                     ExactText(quality.Generalisation.Values[k]),
                     ExactText(quality.Generalisation.StandardErrors[k]),
                     ExactText(quality.Specificity.Values[k]),
                     ExactText(quality.Specificity.StandardErrors[k])});
  }
  return text;
}

std::string DistanceTable(const CohortGroup& group, const CohortQuality& quality)
{
  std::string text = CsvLine({"case", "label", "mahalanobis", "modes", "p", "q", "outside_mm",
                              "largest_z", "x_mm", "y_mm", "z_mm", "side"});
  for (const UnusualCase& one : quality.Distances)
  {
    const CohortRow& row = group.Rows[one.Row];
    const Vector3& point = quality.Surface.Points[one.Point];
    text +=
        CsvLine({row.Case, std::to_string(row.Result.Structure.Label), ExactText(one.Mahalanobis),
                 std::to_string(quality.ModeCount), ExactText(one.P), ExactText(one.Discovery),
                 ExactText(one.OutsideMillimeters), ExactText(one.LargestZ), ExactText(point[0]),
                 ExactText(point[1]), ExactText(point[2]), OrientationLetters(point.normalized())});
  }
  return text;
}

vtkSmartPointer<vtkPolyData> DistanceSurface(const CohortGroup& group, const CohortQuality& quality)
{
  const auto surface = MeanSurface(quality.Surface);
  AddPointMap(surface, "sd (mm)", quality.PointDeviations);
  for (Eigen::Index k = 0; k < quality.Maps.cols(); ++k)
  {
    const UnusualCase& one = quality.Distances[static_cast<std::size_t>(k)];
    AddPointMap(surface, "z " + group.Rows[one.Row].Case, quality.Maps.col(k));
  }
  return surface;
}
} // namespace

std::vector<std::string> CohortQualityNames()
{
  return {"model_quality.csv", "distances.csv", "distances.vtp"};
}

void WriteCohortQuality(const CohortGroup& group, const CohortQuality& quality,
                        const std::filesystem::path& folder)
{
  WriteWholeFile(folder / "model_quality.csv", QualityTable(quality.Model));
  WriteWholeFile(folder / "distances.csv", DistanceTable(group, quality));
  WriteSurface(folder / "distances.vtp", DistanceSurface(group, quality));
}
} // namespace palpate
