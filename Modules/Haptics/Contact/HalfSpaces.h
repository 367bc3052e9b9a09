#pragma once

#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// The points p with Normal . p >= Offset: where a tool may be beside one touched plane.
struct HalfSpace
{
  Vector3 Normal; ///< unit vector
  double Offset;  ///< in the unit of the points
};

/// The point that all half-spaces hold nearest to some goal.
struct NearestHeld
{
  Vector3 Point;
  /// False where no point is held by all of them; then Point is held by as many as were joined
  /// before.
  bool IsHeld;
};

/// Exact up to rounding, with up to three of the planes touched: the constrained proxy of Zilles
/// and Salisbury (IROS 1995), for any number of planes. Planes are added one by one; one that cuts
/// off the point so far holds the next (R. Seidel, "Small-dimensional linear programming and convex
/// hulls made easy", Discrete & Computational Geometry 6, 1991). Time is linear in `count` but in
/// rare orders. No tolerance is absolute. Allocates nothing.
NearestHeld NearestInHalfSpaces(const Vector3& goal, const HalfSpace* spaces,
                                std::size_t count) noexcept;
} // namespace palpate
