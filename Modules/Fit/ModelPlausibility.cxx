#include "ModelPlausibility.h"

#include "DecimalText.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
namespace
{
// In units of the farthest distance. An atlas's 110 structures at degree 12, with the most hidden
// surface allowed, stay between -0.74 and 1.03; diverging models reach 10 and more.
constexpr double FarthestReach = 2.0;
constexpr double FarthestBelow = -1.0;

using Range = std::array<double, 2>;

Range RadiusOf(const FitResult& result)
{
  Range range{};
  result.ModelSurface->GetPointData()->GetArray("Radius")->GetRange(range.data());
  return range;
}

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
  const Range radius = RadiusOf(result);
  const double farthest = FarthestDistance(result.Surface, CenterOf(result.Model));
  // False for NaN.
  const bool isWithinReach =
      radius[0] >= FarthestBelow * farthest && radius[1] <= FarthestReach * farthest;
  const bool isSolid = result.ModelMilliliters > 0.0 && std::isfinite(result.ModelMilliliters);
  if (isWithinReach && isSolid)
  {
    return {};
  }
  return "is not described by the model of degree " + std::to_string(DegreeOf(result.Model)) +
         ": the model's radius runs from " + SignificantText(radius[0], 3) + " to " +
         SignificantText(radius[1], 3) + " mm, while the structure's surface lies within " +
         SignificantText(farthest, 3) + " mm of the centre, and it encloses " +
         SignificantText(result.ModelMilliliters, 6) + " ml instead of " +
         SignificantText(result.InputMilliliters(), 3) + " ml";
}

std::string RemarkOnNegativeRadius(const FitResult& result)
{
  const double lowest = RadiusOf(result)[0];
  return lowest < 0.0
             ? "the model's radius is negative in some directions (down to " +
                   SignificantText(lowest, 2) + " mm): its surface passes through the centre there"
             : std::string();
}
} // namespace palpate
