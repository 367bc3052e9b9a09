#pragma once

#include "IndexedMesh.h"
#include "Status.h"
#include "TriangleTree.h"

namespace palpate
{
/// A mesh that is prepared for rays through it. It refers to the mesh, which has to stay.
class MeshRays
{
public:
  /// Fails as TriangleTree::Make does.
  static Status Make(const IndexedMesh& mesh, MeshRays& made);

  /// The distance (mm) from a point inside a closed mesh, or one of its points, along a unit vector
  /// to the next triangle that the ray meets; triangles with the mesh's point `own` are left out.
  /// NaN if there is none, or if the ray enters the body there, so that it began outside.
  double ExitFrom(const Vector3& point, const Vector3& direction, int own = -1) const;

private:
  const IndexedMesh* Mesh = nullptr;
  TriangleTree Tree;
};
} // namespace palpate
