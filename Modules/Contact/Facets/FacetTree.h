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
/// A triangle mesh with a bounding-volume hierarchy. Immutable; queries are noexcept and do not
/// allocate. Lengths are mm in the world.
class FacetTree
{
public:
  using Triangle = std::array<int, 3>;

  struct Nearest
  {
    Vector3 PointWorld = Vector3::Zero();
    double Distance; ///< mm; infinite if nothing is within the given limit
  };

  /// Degenerate triangles are skipped. Fails for points that are not finite, indices out of range,
  /// and meshes without any valid triangle.
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

  /// The nearest point of the mesh at a distance of at most `within`.
  Nearest NearestTo(const Vector3& pointWorld, double within) const noexcept;
  /// First contact of a moving sphere.
  SweepHit Sweep(const SphereMotion& motion) const noexcept;
  /// Whether a closed mesh contains a point, by the crossings of three rays.
  bool IsInside(const Vector3& pointWorld) const noexcept;

private:
  FacetTree() = default;
  SweepHit SweepNear(const SphereMotion& motion) const noexcept;
  bool CrossesOddly(const Vector3& start, const Vector3& direction) const noexcept;

  BoxHierarchy Boxes;
  std::vector<Facet> Facets; // in the order of the boxes
};
} // namespace palpate
