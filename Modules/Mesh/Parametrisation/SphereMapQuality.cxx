#include "SphereMapQuality.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <limits>

namespace palpate
{
namespace
{
// Rounding of a sum of some 1e7 terms stays well below; a second sheet would add 4 pi.
constexpr double SolidAngleTolerance = 1e-6;

std::array<Vector3, 3> CornersOf(const std::vector<Vector3>& points, const std::array<int, 3>& t)
{
  return {points[static_cast<std::size_t>(t[0])], points[static_cast<std::size_t>(t[1])],
          points[static_cast<std::size_t>(t[2])]};
}

double AreaOf(const std::array<Vector3, 3>& p)
{
  return 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
}

double SolidAngleOf(const std::array<Vector3, 3>& q)
{
  return 2.0 * std::atan2(SphericalDeterminant(q[0], q[1], q[2]),
                          1.0 + q[0].dot(q[1]) + q[1].dot(q[2]) + q[2].dot(q[0]));
}
} // namespace

double SphericalDeterminant(const Vector3& a, const Vector3& b, const Vector3& c) noexcept
{
  return a.dot((b - a).cross(c - a));
}

bool IsBijective(const std::vector<std::array<int, 3>>& triangles,
                 const std::vector<Vector3>& directions) noexcept
{
  double sum = 0.0;
  for (const std::array<int, 3>& t : triangles)
  {
    const std::array<Vector3, 3> q = CornersOf(directions, t);
    if (!(SphericalDeterminant(q[0], q[1], q[2]) > 0.0))
    {
      return false;
    }
    sum += SolidAngleOf(q);
  }
  return std::abs(sum - 4.0 * M_PI) <= SolidAngleTolerance;
}

SphereMapQuality MeasureSphereMap(const IndexedMesh& mesh,
                                  const std::vector<Vector3>& directions) noexcept
{
  double area = 0.0;
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    area += AreaOf(CornersOf(mesh.Points, t));
  }
  SphereMapQuality quality;
  quality.LeastRatio = std::numeric_limits<double>::infinity();
  for (const std::array<int, 3>& t : mesh.Triangles)
  {
    const std::array<Vector3, 3> q = CornersOf(directions, t);
    const double angle = SolidAngleOf(q);
    const double share = AreaOf(CornersOf(mesh.Points, t)) / area;
    const double ratio = angle / (4.0 * M_PI) / share;
    quality.AreaDistortion += std::abs(angle / (4.0 * M_PI) - share);
    quality.LeastRatio = std::min(quality.LeastRatio, ratio);
    quality.LargestRatio = std::max(quality.LargestRatio, ratio);
  }
  return quality;
}

Status CheckSphereMap(const SphereMapQuality& quality)
{
  if (quality.AreaDistortion <= LargestAreaDistortion)
  {
    return Status::Success();
  }
  char text[160];
  std::snprintf(text, sizeof(text),
                "is too long and thin for a surface model: its map to the sphere distorts areas by "
                "%.3f (at most %.2f)",
                quality.AreaDistortion, LargestAreaDistortion);
  return Status::Failure(text);
}
} // namespace palpate
