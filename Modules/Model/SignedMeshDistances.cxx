#include "SignedMeshDistances.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace palpate
{
std::vector<std::uint8_t> InsideOf(const std::vector<Vector3>& points, const IndexedMesh& surface)
{
  std::vector<std::uint8_t> inside(points.size(), 0);
  if (points.empty())
  {
    return inside;
  }
  // Any start of the rays will do.
  Eigen::AlignedBox3d box;
  for (const Vector3& point : points)
  {
    box.extend(point);
  }
  const Vector3 start = box.center();
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
    inside[i] = IsWithinCrossings(crossings[i], (points[i] - start).norm()) ? 1 : 0;
  }
  return inside;
}

bool IsWithinCrossings(const std::vector<RayCrossing>& crossings, double distance)
{
  return std::count_if(crossings.begin(), crossings.end(),
                       [distance](const RayCrossing& crossing)
                       { return crossing.Distance > distance; }) %
             2 ==
         1;
}
} // namespace palpate
