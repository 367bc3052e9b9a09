#include "StarShape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
struct Facet
{
  Vector3 Centroid;
  Vector3 DoubledArea; // along the outward normal
};

std::vector<Facet> Facets(const IndexedMesh& mesh)
{
  std::vector<Facet> facets;
  facets.reserve(mesh.Triangles.size());
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3& a = mesh.Points[static_cast<std::size_t>(t[0])];
    const Vector3& b = mesh.Points[static_cast<std::size_t>(t[1])];
    const Vector3& c = mesh.Points[static_cast<std::size_t>(t[2])];
    facets.push_back({(a + b + c) / 3.0, (b - a).cross(c - a)});
  }
  return facets;
}

// Doubled area of the facets that face away from the centre. Every n-th facet is used.
double AreaFacingAway(const std::vector<Facet>& facets, const Vector3& center, std::size_t stride)
{
  double area = 0.0;
  for (std::size_t i = 0; i < facets.size(); i += stride)
  {
    if (facets[i].DoubledArea.dot(facets[i].Centroid - center) <= 0.0)
    {
      area += facets[i].DoubledArea.norm();
    }
  }
  return area;
}

// From `start`, by steps along the axes that are halved when none of them improves the cost.
template <typename Cost>
Vector3 CompassSearch(const Vector3& start, double step, double smallestStep, const Cost& cost)
{
  Vector3 best = start;
  double bestCost = cost(best);
  while (step >= smallestStep && bestCost > 0.0)
  {
    Vector3 next = best;
    for (int direction = 0; direction < 6; ++direction)
    {
      const Vector3 candidate =
          best + (direction % 2 == 0 ? step : -step) * Vector3::Unit(direction / 2);
      const double candidateCost = cost(candidate);
      if (candidateCost < bestCost)
      {
        bestCost = candidateCost;
        next = candidate;
      }
    }
    if (next == best)
    {
      step *= 0.5;
    }
    best = next;
  }
  return best;
}
} // namespace

Vector3 VolumeCentroid(const IndexedMesh& mesh)
{
  if (mesh.Points.empty())
  {
    return Vector3::Zero();
  }
  const Vector3 origin = mesh.Points.front();
  Vector3 moment = Vector3::Zero();
  double volume = 0.0; // six times the volume
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const Vector3 a = mesh.Points[static_cast<std::size_t>(t[0])] - origin;
    const Vector3 b = mesh.Points[static_cast<std::size_t>(t[1])] - origin;
    const Vector3 c = mesh.Points[static_cast<std::size_t>(t[2])] - origin;
    const double signedVolume = a.dot(b.cross(c));
    volume += signedVolume;
    moment += signedVolume * (a + b + c) / 4.0;
  }
  return volume != 0.0 ? Vector3(origin + moment / volume) : origin;
}

StarShapeVerdict JudgeStarShape(const IndexedMesh& mesh, const Vector3& center)
{
  const std::vector<Facet> facets = Facets(mesh);
  double total = 0.0;
  double hidden = 0.0;
  std::vector<Vector3> directions;
  std::vector<double> distances;
  std::vector<int> triangles;
  for (std::size_t i = 0; i < facets.size(); ++i)
  {
    const Vector3 arm = facets[i].Centroid - center;
    const double area = facets[i].DoubledArea.norm();
    total += area;
    if (facets[i].DoubledArea.dot(arm) <= 0.0)
    {
      hidden += area;
      continue;
    }
    directions.push_back(arm.normalized());
    distances.push_back(arm.norm());
    triangles.push_back(static_cast<int>(i));
  }
  const std::vector<int> nearer =
      DirectionCaster(directions).CountNearer(mesh, center, triangles, distances);
  for (std::size_t i = 0; i < nearer.size(); ++i)
  {
    if (nearer[i] > 0)
    {
      hidden += facets[static_cast<std::size_t>(triangles[i])].DoubledArea.norm();
    }
  }
  const double percent = total > 0.0 ? 100.0 * hidden / total : 100.0;
  return {percent < 0.01, std::min(percent, 100.0)};
}

Vector3 MostVisibleCenter(const IndexedMesh& mesh)
{
  const std::vector<Facet> facets = Facets(mesh);
  constexpr int GridSteps = 8;
  constexpr std::size_t SampledFacets = 4000;
  const std::size_t stride = std::max<std::size_t>(1, facets.size() / SampledFacets);
  Eigen::AlignedBox3d box;
  for (const Vector3& point : mesh.Points)
  {
    box.extend(point);
  }
  Vector3 best = VolumeCentroid(mesh);
  double bestArea = AreaFacingAway(facets, best, stride);
  for (int n = 0; n < GridSteps * GridSteps * GridSteps; ++n)
  {
    const int rest = n / GridSteps;
    const int slice = rest / GridSteps;
    const Vector3 cell(n % GridSteps, rest % GridSteps, slice);
    const Vector3 parts = (cell + Vector3::Constant(0.5)) / GridSteps;
    const Vector3 candidate = box.min() + parts.cwiseProduct(box.sizes());
    const double area = AreaFacingAway(facets, candidate, stride);
    if (area < bestArea)
    {
      bestArea = area;
      best = candidate;
    }
  }
  const double size = box.sizes().maxCoeff();
  return CompassSearch(best, size / GridSteps / 2.0, size / 100.0,
                       [&mesh](const Vector3& center)
                       { return JudgeStarShape(mesh, center).HiddenPercent; });
}
} // namespace palpate
