#pragma once

#include "Vector3.h"

#include <array>

namespace palpate
{
/// A triangle of great circles on the unit sphere, smaller than a hemisphere.
struct SphericalTriangle
{
  std::array<Vector3, 3> Corners; ///< unit vectors

  /// A unit vector inside.
  Vector3 Center() const noexcept;
  /// Angle (rad) from Center() that no point of the triangle exceeds: a cap smaller than a
  /// hemisphere is convex, so the corners decide.
  double Reach() const noexcept;
  /// The four triangles between corners and middles of the edges; together they are this one.
  std::array<SphericalTriangle, 4> Split() const noexcept;
};
} // namespace palpate
