#include "RadialSampling.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
double AreaWeightOf(const IndexedMesh& mesh, const RayCrossing& crossing, const Vector3& direction,
                    double solidAngle)
{
  const std::array<int, 3>& ids = mesh.Triangles[static_cast<std::size_t>(crossing.Triangle)];
  const Vector3& a = mesh.Points[static_cast<std::size_t>(ids[0])];
  const Vector3 normal = (mesh.Points[static_cast<std::size_t>(ids[1])] - a)
                             .cross(mesh.Points[static_cast<std::size_t>(ids[2])] - a);
  const double incidence = std::max(0.05, std::abs(normal.normalized().dot(direction)));
  return solidAngle * crossing.Distance * crossing.Distance * incidence;
}

RadialSamples SampleRadially(const IndexedMesh& mesh, const Vector3& center, int frequency)
{
  const IcosahedronDirections sphere(frequency);
  const std::vector<Vector3>& directions = sphere.Directions();
  const std::vector<double> angles = sphere.SolidAngles();
  const auto crossings = DirectionCaster(directions).Cast(mesh, center);
  RadialSamples samples;
  for (std::size_t i = 0; i < directions.size(); ++i)
  {
    if (!crossings[i].empty())
    {
      const RayCrossing& outermost = crossings[i].back();
      samples.Directions.push_back(directions[i]);
      samples.Radii.push_back(outermost.Distance);
      samples.Weights.push_back(AreaWeightOf(mesh, outermost, directions[i], angles[i]));
    }
  }
  return samples;
}
} // namespace palpate
