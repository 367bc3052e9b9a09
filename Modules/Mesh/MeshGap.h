#pragma once

#include "IndexedMesh.h"
#include "Status.h"
#include "TriangleTree.h"

namespace palpate
{
/// The smallest distance between two surfaces, and where it is. 0, at a common point, if they
/// touch or cross; the inside of a closed surface does not count as its surface.
struct MeshGap
{
  Vector3 PointOfOne = Vector3::Zero();
  Vector3 PointOfOther = Vector3::Zero();
  double Distance = 0.0; ///< mm
};

/// A mesh that is prepared for gaps to several others. It refers to the mesh, which has to stay.
class GapSurface
{
public:
  /// Fails as TriangleTree::Make does.
  static Status Make(const IndexedMesh& mesh, GapSurface& made);

  /// Exact to rounding.
  MeshGap To(const GapSurface& other) const;

private:
  const IndexedMesh* Mesh = nullptr;
  TriangleTree Tree;
};

/// The gap between two meshes alone. Fails as TriangleTree::Make does.
Status FindMeshGap(const IndexedMesh& one, const IndexedMesh& other, MeshGap& gap);
} // namespace palpate
