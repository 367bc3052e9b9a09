#pragma once

#include "BoxHierarchy.h"
#include "Status.h"
#include "TriangleSweep.h"
#include "Vector3.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// A triangle mesh in boxes within boxes, in one flat list. Immutable; queries are noexcept and
/// allocate nothing. Lengths are mm in the world.
class FacetTree
{
public:
  using Triangle = std::array<int, 3>;

  struct Nearest
  {
    Vector3 PointWorld = Vector3::Zero();
    double Distance; ///< mm; infinite where nothing is nearer than was asked for
  };

  /// Triangles without area are left out. Refuses points that are not finite, numbers of points
  /// that there are not, and what leaves no triangle.
  static Status Make(const std::vector<Vector3>& pointsWorld,
                     const std::vector<Triangle>& triangles,
                     std::shared_ptr<const FacetTree>& tree);

  const Eigen::AlignedBox3d& BoundsWorld() const noexcept
  {
    return this->Boxes.Nodes().front().Box;
  }
  std::size_t Bytes() const noexcept
  {
    return this->Boxes.Bytes() + this->Facets.size() * sizeof(Facet);
  }
  std::size_t FacetCount() const noexcept { return this->Facets.size(); }

  /// The nearest point of the mesh that is not farther than `within`.
  Nearest NearestTo(const Vector3& pointWorld, double within) const noexcept;
  /// Where a moving sphere first touches.
  SweepHit Sweep(const SphereMotion& motion) const noexcept;
  /// Whether a closed mesh holds a point, by how often a ray crosses it. For starting only: a ray
  /// through an edge may be wrong.
  bool IsInside(const Vector3& pointWorld) const noexcept;

private:
  FacetTree() = default;
  SweepHit SweepNear(const SphereMotion& motion) const noexcept;

  BoxHierarchy Boxes;
  std::vector<Facet> Facets; // in the order of the boxes
};
} // namespace palpate
