#include "ClosestPointDistances.h"

#include "MeshConversion.h"
#include "NearestOnMesh.h"
#include "SignedMeshDistances.h"

#include "vtkPoints.h"
#include "vtkPolyData.h"

#include <algorithm>
#include <limits>

namespace palpate
{
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
  const std::vector<std::uint8_t> inside = InsideOf(points, surface);
  for (std::size_t i = 0; i < points.size(); ++i)
  {
    distances[i] = inside[i] != 0 ? -distances[i] : distances[i];
  }
  return distances;
}

bool IsInside(const std::vector<RayCrossing>& crossings, double distance)
{
  return IsWithinCrossings(crossings, distance);
}
} // namespace palpate
