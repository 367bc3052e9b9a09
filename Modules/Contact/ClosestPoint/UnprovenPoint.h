#pragma once

#include "ClosestPoint.h"
#include "SampleGeometry.h"

#include <cmath>
#include <limits>

namespace palpate
{
/// The surface's point at a direction as if it were closest to the query (world, mm), without a
/// search: descents and tracking can start from it. Its errors are infinite.
template <typename Surface>
ClosestPointOf<Surface> UnprovenPoint(const Surface& model, const Vector3& direction,
                                      const Vector3& queryWorld) noexcept
{
  const Vector3 query = queryWorld - model.CenterWorld();
  ClosestPointOf<Surface> point;
  point.Direction = direction;
  point.SampleDirection = direction;
  point.Sample = model.EvaluateSecondOrder(direction);
  point.Expansion = SquaredDistance(direction, point.Sample, query);
  const Vector3 surface = PointOf(direction, point.Sample);
  point.Normal = NormalOf(direction, point.Sample);
  point.PointWorld = model.CenterWorld() + surface;
  const Vector3 offset = query - surface;
  point.SignedDistance = std::copysign(offset.norm(), offset.dot(point.Normal));
  point.DistanceError = std::numeric_limits<double>::infinity();
  point.PositionError = std::numeric_limits<double>::infinity();
  point.Evaluations = 1;
  point.State = ClosestPointOf<Surface>::Outcome::Limit;
  return point;
}
} // namespace palpate
