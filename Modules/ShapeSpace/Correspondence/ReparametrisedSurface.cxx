#include "ReparametrisedSurface.h"

#include "IcosahedronDirections.h"
#include "MeshDistances.h"
#include "SphereMapQuality.h"
#include "SurfaceModelSolver.h"
#include "SurfaceSamples.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numeric>
#include <vector>

namespace palpate
{
namespace
{
constexpr int LeastFrequency = 24;
constexpr double RefitRidge = 1e-7; // the samples determine the surface
constexpr double TangentShare = 0.05;
constexpr int RefitIterations = 15;

using FirstOrder = SurfaceModel::Sample;

SurfaceSamples SamplesAt(const SurfaceModel& surface, const std::vector<Vector3>& places,
                         const IcosahedronDirections& sphere)
{
  SurfaceSamples samples;
  samples.Parameters = sphere.Directions();
  for (const Vector3& place : places)
  {
    const FirstOrder sample = surface.Evaluate(place);
    samples.Points.push_back(sample.Point);
    samples.Normals.push_back(SurfaceModel::AreaVector(sample).normalized());
  }
  samples.Weights = PointAreas({samples.Points, sphere.Triangles()});
  const double total = std::accumulate(samples.Weights.begin(), samples.Weights.end(), 0.0);
  for (double& weight : samples.Weights)
  {
    weight /= total;
  }
  return samples;
}

// From the nearest point of the surface that Gauss-Newton steps reach from `place`.
double DistanceFrom(const SurfaceModel& surface, const Vector3& point, Vector3 place)
{
  constexpr int Steps = 5;
  constexpr double Longest = 0.1; // rad
  double least = (surface.Point(place) - point).norm();
  for (int step = 0; step < Steps; ++step)
  {
    const FirstOrder sample = surface.Evaluate(place);
    const Vector3 left = point - sample.Point;
    const double aa = sample.First[0].squaredNorm();
    const double bb = sample.First[1].squaredNorm();
    const double ab = sample.First[0].dot(sample.First[1]);
    const double determinant = aa * bb - ab * ab + 1e-12 * (aa + bb) * (aa + bb) + 1e-300;
    const double a = left.dot(sample.First[0]);
    const double b = left.dot(sample.First[1]);
    Vector3 move = (bb * a - ab * b) / determinant * sample.Tangents[0] +
                   (aa * b - ab * a) / determinant * sample.Tangents[1];
    move *= std::min(1.0, Longest / (move.norm() + 1e-300));
    place = (place + move).normalized();
    least = std::min(least, (surface.Point(place) - point).norm());
  }
  return least;
}

void MeasureMap(const IcosahedronDirections& sphere, const std::vector<Vector3>& places,
                ReparametrisedSurface& result)
{
  const std::vector<Vector3>& before = sphere.Directions();
  const std::vector<double> angles = sphere.SolidAngles();
  double squares = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double turn = std::atan2(before[i].cross(places[i]).norm(), before[i].dot(places[i]));
    squares += angles[i] / (4.0 * M_PI) * turn * turn;
  }
  result.RmsTurn = std::sqrt(squares);
  result.IsOneToOne = IsBijective(sphere.Triangles(), places);
  for (const std::array<int, 3>& t : sphere.Triangles())
  {
    const auto at = [&](const std::vector<Vector3>& all, std::size_t i) -> const Vector3&
    { return all[static_cast<std::size_t>(t[i])]; };
    const double ratio = SphericalDeterminant(at(places, 0), at(places, 1), at(places, 2)) /
                         SphericalDeterminant(at(before, 0), at(before, 1), at(before, 2));
    result.LeastAreaRatio = std::min(result.LeastAreaRatio, ratio);
  }
}
} // namespace

ReparametrisedSurface Reparametrise(const SurfaceModel& surface, const SphereFlow& flow)
{
  const IcosahedronDirections sphere(std::max(LeastFrequency, 2 * surface.Degree()));
  std::vector<Vector3> places = sphere.Directions();
  flow.Map(places);
  ReparametrisedSurface result;
  MeasureMap(sphere, places, result);
  const SurfaceSamples samples = SamplesAt(surface, places, sphere);
  SurfaceModelSolver solver(surface.Degree(), RefitRidge);
  if (!solver.FitPoints(samples))
  {
    result.IsOneToOne = false;
    return result;
  }
  solver.SetTangentWeights(samples, std::vector<double>(places.size(), TangentShare));
  solver.FitNormals(samples, RefitIterations);
  result.Surface = solver.Surface();
  double squares = 0.0;
  for (std::size_t i = 0; i < places.size(); ++i)
  {
    const double distance =
        DistanceFrom(surface, result.Surface.Point(samples.Parameters[i]), places[i]);
    squares += samples.Weights[i] * distance * distance;
    result.LargestChange = std::max(result.LargestChange, distance);
  }
  result.RmsChange = std::sqrt(squares);
  return result;
}
} // namespace palpate
