#include "RadialSampling.h"

#include "DirectionCaster.h"
#include "IcosahedronDirections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

namespace palpate
{
namespace
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
} // namespace

RadialSampling SampleRadially(const IndexedMesh& mesh, const Vector3& centerWorld,
                              std::vector<Vector3> directions, std::vector<double> solidAngles,
                              RadialCrossing crossing, const KernelProgress& progress)
{
  RadialSampling made;
  made.CenterWorld = centerWorld;
  made.Seen = JudgeStarShape(mesh, centerWorld);
  if (progress && !progress(0.6))
  {
    return made;
  }
  const auto crossings = DirectionCaster(directions).Cast(mesh, centerWorld);
  made.Directions = std::move(directions);
  made.SolidAngles = std::move(solidAngles);
  double multiple = 0.0;
  double missed = 0.0;
  for (std::size_t i = 0; i < crossings.size(); ++i)
  {
    const auto& list = crossings[i];
    const double angle = made.SolidAngles[i];
    made.Crossings.push_back(static_cast<int>(list.size()));
    multiple += list.size() > 1 ? angle : 0.0;
    if (list.empty())
    {
      missed += angle;
      made.Radii.push_back(0.0);
      made.AreaWeights.push_back(0.0);
      continue;
    }
    const RayCrossing& one = crossing == RadialCrossing::Outermost ? list.back() : list.front();
    made.Radii.push_back(one.Distance);
    made.AreaWeights.push_back(AreaWeightOf(mesh, one, made.Directions[i], angle));
  }
  const double total = std::accumulate(made.SolidAngles.begin(), made.SolidAngles.end(), 0.0);
  made.MultiplePercent = 100.0 * multiple / total;
  made.MissedPercent = 100.0 * missed / total;
  return made;
}

RadialSampling SampleRadially(const IndexedMesh& mesh, const Vector3& centerWorld, int frequency,
                              const KernelProgress& progress)
{
  const IcosahedronDirections sphere(frequency);
  return SampleRadially(mesh, centerWorld, sphere.Directions(), sphere.SolidAngles(),
                        RadialCrossing::Outermost, progress);
}

RadialSamples SamplesOf(const RadialSampling& sampling, RadialWeight weight)
{
  RadialSamples samples;
  for (std::size_t i = 0; i < sampling.Directions.size(); ++i)
  {
    if (sampling.Crossings[i] > 0)
    {
      samples.Directions.push_back(sampling.Directions[i]);
      samples.Radii.push_back(sampling.Radii[i]);
      samples.Weights.push_back(weight == RadialWeight::Area         ? sampling.AreaWeights[i]
                                : weight == RadialWeight::SolidAngle ? sampling.SolidAngles[i]
                                                                     : 1.0);
    }
  }
  return samples;
}
} // namespace palpate
