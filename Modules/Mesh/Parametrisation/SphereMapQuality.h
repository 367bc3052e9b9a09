#pragma once

#include "IndexedMesh.h"
#include "Status.h"

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

/// Rods of 1:30 have 0.38, helices of 2, 2.5 and 3.5 turns 0.416, 0.437 and 0.5, needles of 1:60
/// 0.47; organs 0.03 to 0.25. Beyond, surfaces of degree 20 lose ends or cross themselves.
constexpr double LargestAreaDistortion = 0.42;

/// Fails beyond LargestAreaDistortion, with a message that is a predicate of the surface.
Status CheckSphereMap(const SphereMapQuality& quality);
} // namespace palpate
