#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// det(a, b, c) of three directions, computed from their differences: its relative error is some
/// 1e-16 over the sine of the triangle's least angle. Positive if the spherical triangle runs
/// counter-clockwise seen from outside.
double SphericalDeterminant(const Vector3& a, const Vector3& b, const Vector3& c) noexcept;

/// True if every triangle is positively oriented and the solid angles sum to 4 pi (within 1e-6):
/// then the map of a closed surface to the unit sphere is one to one. False if any number is NaN.
bool IsBijective(const std::vector<std::array<int, 3>>& triangles,
                 const std::vector<Vector3>& directions) noexcept;

/// How a map of a surface to the unit sphere distributes area.
struct SphereMapQuality
{
  /// r is a triangle's share of the sphere over its share of the surface. A sphere has 0, 1, 1.
  double AreaDistortion = 0.0; ///< mean of |r - 1|, weighted by surface area; 0 to 2
  double LeastRatio = 0.0;     ///< smallest r
  double LargestRatio = 0.0;   ///< largest r
};

/// `directions` are unit vectors, one per point of `mesh`, whose triangles have some area and
/// indices inside. Does not allocate.
SphereMapQuality MeasureSphereMap(const IndexedMesh& mesh,
                                  const std::vector<Vector3>& directions) noexcept;
} // namespace palpate
