#pragma once

#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// The directions of an icosahedron whose edges are divided into `frequency` parts and whose points
/// are projected to the unit sphere: 10 f^2 + 2 directions, 20 f^2 triangles (f = 20: 4,002 and
/// 8,000). The icosahedron's corners are the cyclic permutations of (0, +-1, +-golden ratio), so
/// the set is symmetric under a change of sign of any coordinate.
class IcosahedronDirections
{
public:
  /// `frequency` >= 1; smaller values count as 1.
  explicit IcosahedronDirections(int frequency);

  int Frequency() const noexcept { return this->Parts; }

  /// Unit vectors.
  const std::vector<Vector3>& Directions() const noexcept { return this->Points; }
  /// Indices into Directions(), counter-clockwise seen from outside.
  const std::vector<std::array<int, 3>>& Triangles() const noexcept { return this->Faces; }
  /// Solid angle (sr) of each direction: a third of the areas of its spherical triangles; the sum
  /// is 4 pi.
  std::vector<double> SolidAngles() const;
  /// Bounds the angle (rad) from any direction to the closest of these: the largest distance of a
  /// triangle's corners from its centre.
  double LargestGap() const;

private:
  int Parts;
  std::vector<Vector3> Points;
  std::vector<std::array<int, 3>> Faces;
};
} // namespace palpate
