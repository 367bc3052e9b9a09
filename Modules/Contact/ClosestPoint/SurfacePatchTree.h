#pragma once

#include "SphericalTriangle.h"
#include "SurfaceKind.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// A hierarchy of volumes around the parts of a surface: the triangles of an icosahedron,
/// each split into four a number of times. All have a sphere around them, the finest a SurfacePatch
/// or SurfaceBox too. Nodes are numbered level by level; points are relative to the surface's
/// centre, mm. Immutable; its queries are const, thread-safe and allocation-free.
template <typename Surface>
class SurfacePatchTreeOf
{
public:
  using Bounds = typename SurfaceKind<Surface>::Bounds;
  using Patch = typename SurfaceKind<Surface>::Patch;

  /// `levels` >= 0 is the number of times the 20 triangles are split. Evaluates the surface in
  /// 20 * 4^levels directions.
  SurfacePatchTreeOf(const Surface& surface, const Bounds& bounds, int levels);

  static constexpr int RootCount = 20;
  /// Number of nodes except the finest, and of all nodes.
  int InnerCount() const noexcept { return NodeCount() - static_cast<int>(this->Patches.size()); }
  int NodeCount() const noexcept { return static_cast<int>(this->Spheres.size()); }
  bool IsInner(int node) const noexcept { return node < this->InnerCount(); }
  /// The first of the four parts of an inner node; the others follow.
  static constexpr int FirstPart(int node) noexcept { return RootCount + 4 * node; }

  /// Lower bound (mm) of the distance from the query to the node's surface, up to rounding.
  double LowerDistance(int node, const Vector3& query) const noexcept
  {
    if (!this->IsInner(node))
    {
      return this->PatchOf(node).LowerDistance(query);
    }
    const Ball& sphere = this->BallOf(node);
    return std::max(0.0, (query - sphere.Center).norm() - sphere.Radius);
  }
  struct Ball
  {
    Vector3 Center;
    double Radius;
  };
  /// Around the node's surface.
  const Ball& BallOf(int node) const noexcept
  {
    return this->Spheres[static_cast<std::size_t>(node)];
  }
  /// Around the samples in the middles of the node's finest parts; a point for one of these.
  Ball MiddlesOf(int node) const noexcept
  {
    return this->IsInner(node) ? this->BallOf(node) : Ball{this->PatchOf(node).Point, 0.0};
  }
  /// Square of the distance (mm^2) from the query to the middle of the node.
  double SquaredCenterDistance(int node, const Vector3& query) const noexcept
  {
    return (query - this->MiddlesOf(node).Center).squaredNorm();
  }
  SphericalTriangle Triangle(int node) const noexcept;
  const SphericalCap& CapOf(int node) const noexcept
  {
    return this->Caps[static_cast<std::size_t>(node)];
  }

  std::size_t Bytes() const noexcept
  {
    return this->Roots.size() * sizeof(SphericalTriangle) +
           this->Caps.size() * sizeof(SphericalCap) + this->Spheres.size() * sizeof(Ball) +
           this->Patches.size() * sizeof(Patch);
  }

  /// Bounds of the distance of the surface from its centre, mm; the lower one is 0 for other
  /// surfaces.
  double LeastRadius() const noexcept { return std::max({0.0, this->Lowest, -this->Highest}); }
  double LargestRadius() const noexcept { return std::max(-this->Lowest, this->Highest); }

private:
  const Patch& PatchOf(int node) const noexcept
  {
    return this->Patches[static_cast<std::size_t>(node - this->InnerCount())];
  }
  Ball Build(const Surface& surface, const Bounds& bounds, int node,
             const SphericalTriangle& triangle);
  Ball BuildPatch(const Surface& surface, const Bounds& bounds, int node);

  std::vector<SphericalTriangle> Roots;
  std::vector<SphericalCap> Caps;
  std::vector<Ball> Spheres;
  std::vector<Patch> Patches;
  double Lowest; // bounds of R, or of the distance from the centre
  double Highest;
};
using SurfacePatchTree = SurfacePatchTreeOf<RadialModel>;
} // namespace palpate
