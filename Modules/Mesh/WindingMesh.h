#pragma once

#include "BoxHierarchy.h"
#include "Vector3.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A closed triangle mesh, which may cross itself, with a bounding-volume hierarchy: how often it
/// winds round a point. Immutable; WindingNumber does not allocate. Lengths are mm in the world.
class WindingMesh
{
public:
  using Triangle = std::array<int, 3>;

  /// Finite points; triangles counter-clockwise seen from outside.
  WindingMesh(std::vector<Vector3> pointsWorld, std::vector<Triangle> triangles);

  const std::vector<Vector3>& PointsWorld() const noexcept { return this->Points; }
  std::size_t Bytes() const noexcept
  {
    return this->Boxes.Bytes() + this->Points.size() * sizeof(Vector3) +
           this->Triangles.size() * sizeof(Triangle);
  }

  /// 0 outside, 1 inside, 2 where two parts overlap, negative in pockets that are inside out: the
  /// signed crossings of a ray, by the median of three rays, since one through an edge may be
  /// wrong.
  int WindingNumber(const Vector3& pointWorld) const noexcept;

private:
  int CrossingsOf(const Vector3& from, const Vector3& to) const noexcept;
  int CrossingOf(const Vector3& from, const Vector3& to, const Triangle& triangle) const noexcept;

  std::vector<Vector3> Points;
  std::vector<Triangle> Triangles; // in the order of the boxes
  BoxHierarchy Boxes;
};
} // namespace palpate
