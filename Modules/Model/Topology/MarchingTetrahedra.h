#pragma once

#include "IndexedMesh.h"
#include "ShapeField.h"
#include "Status.h"

namespace palpate
{
/// The zero level of a field as a closed, oriented two-manifold (outward normals), in the frame of
/// its grid: one vertex on every edge of the Freudenthal triangulation that joins a node inside (>
/// 0) to one outside. No triangle is degenerate, because vertices keep 1 % of their edge from its
/// ends. The surface has the topology of the set of nodes inside (see KuhnNeighborhood): its Euler
/// characteristic is 2 for a set without handles and cavities in one part.
///
/// Fails if a node of the grid's outermost layer is inside, if a value is not finite, or if indices
/// would not fit int.
Status MarchTetrahedra(const ShapeField& field, IndexedMesh& mesh);
} // namespace palpate
