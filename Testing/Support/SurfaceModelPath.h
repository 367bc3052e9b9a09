#pragma once

#include "RandomShapes.h"
#include "SurfaceModel.h"

#include <algorithm>

namespace palpate::test
{
/// A probe that comes down on a random place of the surface and slides over it: from 0.23 mm above
/// to 1.5 mm below where the tool touches.
struct SurfacePath
{
  static constexpr int Ticks = 28;
  static constexpr double Depth = 1.5; // mm
};
template <typename Visit>
void FollowSurfacePath(const SurfaceModel& surface, double toolRadius, Random& random,
                       const Visit& visit)
{
  Vector3 parameter = RandomDirection(random);
  const Vector3 axis = parameter.cross(RandomDirection(random)).normalized();
  for (int tick = 0; tick < SurfacePath::Ticks; ++tick)
  {
    const double depth = std::min(SurfacePath::Depth, 0.1 * tick - 0.23);
    visit(Vector3(surface.Point(parameter) + (toolRadius - depth) * surface.Normal(parameter)));
    if (depth >= SurfacePath::Depth)
    {
      parameter = (Eigen::AngleAxisd(0.002, axis) * parameter).normalized();
    }
  }
}
} // namespace palpate::test
