#pragma once

#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// All directions within an angle of a centre.
struct SphericalCap
{
  Vector3 Center; ///< unit vector
  double Radius;  ///< rad
};

/// A triangle of great circles, smaller than a hemisphere: the cell of searches over the sphere.
/// Splitting leaves no gaps between neighbours, since they compute shared corners identically.
struct SphericalTriangle
{
  std::array<Vector3, 3> Corners; ///< unit vectors

  /// The 20 faces of the icosahedron: they cover the sphere.
  static std::vector<SphericalTriangle> Icosahedron();

  /// A cap that contains the triangle with a margin of some 1e-12, including rounding.
  SphericalCap Cap() const noexcept;
  /// Four triangles from the corners and the midpoints of the sides.
  std::array<SphericalTriangle, 4> Split() const noexcept;
};
} // namespace palpate
