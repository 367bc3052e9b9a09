#pragma once

#include "Vector3.h"

#include <array>
#include <cmath>
#include <vector>

namespace palpate
{
/// Triangles by indices into a list of points. Of a closed surface they run counter-clockwise seen
/// from outside.
struct IndexedMesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<int, 3>> Triangles;
};

/// A triangle's normal with the length of its area, mm^2.
inline Vector3 AreaVector(const IndexedMesh& mesh, const std::array<int, 3>& triangle) noexcept
{
  const Vector3& a = mesh.Points[triangle[0]];
  return 0.5 * (mesh.Points[triangle[1]] - a).cross(mesh.Points[triangle[2]] - a);
}

/// The angle (rad) at one of a triangle's corners, of number 0 to 2.
inline double CornerAngle(const IndexedMesh& mesh, const std::array<int, 3>& triangle,
                          std::size_t corner) noexcept
{
  const Vector3& place = mesh.Points[triangle[corner]];
  const Vector3 one = mesh.Points[triangle[(corner + 1) % 3]] - place;
  const Vector3 other = mesh.Points[triangle[(corner + 2) % 3]] - place;
  return std::atan2(one.cross(other).norm(), one.dot(other));
}
} // namespace palpate
