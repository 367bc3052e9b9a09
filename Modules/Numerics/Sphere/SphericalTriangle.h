#pragma once

#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// All directions within an angle of one.
struct SphericalCap
{
  Vector3 Center; ///< unit vector
  double Radius;  ///< rad
};

/// A triangle of great circles, smaller than a hemisphere: the cell of searches over the sphere.
/// Splitting keeps what the cells cover together, since neighbours round their shared corners
/// alike.
struct SphericalTriangle
{
  std::array<Vector3, 3> Corners; ///< unit vectors

  /// The 20 faces of the icosahedron: they cover the sphere.
  static std::vector<SphericalTriangle> Icosahedron();

  /// A cap that holds the triangle with some 1e-12 to spare, rounding included.
  SphericalCap Cap() const noexcept;
  /// Four triangles over the corners and the middles of the sides.
  std::array<SphericalTriangle, 4> Split() const noexcept;
};
} // namespace palpate
