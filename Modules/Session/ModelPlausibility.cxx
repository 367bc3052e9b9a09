#include "ModelPlausibility.h"

#include "HtmlText.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Ringing of a model that follows its structure stays within some tenths of the farthest radius.
constexpr double FarthestReach = 2.0;

// The distance (mm) of the structure's farthest point from the model's centre.
double FarthestDistance(vtkPolyData* surface, const Vector3& centerWorld)
{
  double farthest = 0.0;
  for (vtkIdType id = 0; id < surface->GetNumberOfPoints(); ++id)
  {
    Vector3 point;
    surface->GetPoint(id, point.data());
    farthest = std::max(farthest, (point - centerWorld).norm());
  }
  return farthest;
}
} // namespace

std::string WhyImplausible(const FitResult& result)
{
  double radius[2];
  result.ModelSurface->GetPointData()->GetArray("Radius")->GetRange(radius);
  const double farthest = FarthestDistance(result.Surface, result.Model.CenterWorld());
  const double reach = std::max(std::abs(radius[0]), std::abs(radius[1]));
  const bool isWithinReach = reach <= FarthestReach * farthest; // false for NaN
  const bool isSolid = result.ModelMilliliters > 0.0 && std::isfinite(result.ModelMilliliters);
  if (isWithinReach && isSolid)
  {
    return {};
  }
  return "is not described by the model of degree " + std::to_string(result.Model.Degree()) +
         ": the model's radius runs from " + SignificantText(radius[0], 3) + " to " +
         SignificantText(radius[1], 3) + " mm, where the structure's surface lies within " +
         SignificantText(farthest, 3) + " mm of the centre, and it encloses " +
         SignificantText(result.ModelMilliliters, 6) + " ml instead of " +
         SignificantText(result.MaskMilliliters, 3) + " ml";
}
} // namespace palpate
