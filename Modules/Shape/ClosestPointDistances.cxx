#include "ClosestPointDistances.h"

#include "MeshConversion.h"
#include "NearestOnMesh.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
Vector3 BoxCenter(const std::vector<Vector3>& points)
{
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points)
  {
    box.extend(point);
  }
  return box.center();
}
} // namespace

std::vector<double> ClosestPointDistances(const std::vector<Vector3>& points,
                                          const IndexedMesh& surface)
{
  std::vector<double> distances(points.size(), std::numeric_limits<double>::quiet_NaN());
  NearestOnMesh nearest;
  if (NearestOnMesh::Make(surface, nearest).IsOk())
  {
    std::transform(points.begin(), points.end(), distances.begin(),
                   [&nearest](const Vector3& point) { return nearest.Find(point).Distance; });
  }
  return distances;
}

std::vector<double> ClosestPointDistances(vtkPoints* points, vtkPolyData* surface)
{
  std::vector<Vector3> list(static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t i = 0; i < list.size(); ++i)
  {
    points->GetPoint(static_cast<vtkIdType>(i), list[i].data());
  }
  return ClosestPointDistances(list, ToIndexedMesh(surface));
}

std::vector<double> SignedDistances(const std::vector<Vector3>& points, const IndexedMesh& surface)
{
  std::vector<double> distances = ClosestPointDistances(points, surface);
  if (points.empty())
  {
    return distances;
  }
  // Any start of the rays will do.
  const Vector3 start = BoxCenter(points);
  std::vector<Vector3> directions;
  directions.reserve(points.size());
  for (const Vector3& point : points)
  {
    const Vector3 arm = point - start;
    directions.push_back(arm.squaredNorm() > 0.0 ? Vector3(arm.normalized()) : Vector3::UnitX());
  }
  const auto crossings = DirectionCaster(directions).Cast(surface, start);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    distances[i] =
        IsInside(crossings[i], (points[i] - start).norm()) ? -distances[i] : distances[i];
  }
  return distances;
}

bool IsInside(const std::vector<RayCrossing>& crossings, double distance)
{
  return std::count_if(crossings.begin(), crossings.end(),
                       [distance](const RayCrossing& crossing)
                       { return crossing.Distance > distance; }) %
             2 ==
         1;
}
} // namespace palpate
