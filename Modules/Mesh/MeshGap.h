#pragma once

#include "IndexedMesh.h"
#include "Status.h"

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

/// Exact to rounding. Fails as TriangleTree::Make does.
Status FindMeshGap(const IndexedMesh& one, const IndexedMesh& other, MeshGap& gap);
} // namespace palpate
