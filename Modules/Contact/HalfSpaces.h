#pragma once

#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// The points p with Normal . p >= Offset: allowed places of a tool at one touched plane.
struct HalfSpace
{
  Vector3 Normal; ///< unit vector
  double Offset;  ///< in the unit of the points
};

/// The point of all half-spaces nearest to a goal.
struct NearestHeld
{
  Vector3 Point;
  /// False if the half-spaces have no common point; then Point is in those that were added before.
  bool IsHeld;
};

/// Exact up to rounding, with up to three active planes: the constrained proxy of Zilles and
/// Salisbury (IROS 1995), for any number of planes. Planes are added one by one; if one excludes
/// the current point, the next point lies on it (R. Seidel, "Small-dimensional linear programming
/// and convex hulls made easy", Discrete & Computational Geometry 6, 1991). Time is linear in
/// `count` except for rare orders. No tolerance is absolute. Does not allocate.
NearestHeld NearestInHalfSpaces(const Vector3& goal, const HalfSpace* spaces,
                                std::size_t count) noexcept;
} // namespace palpate
