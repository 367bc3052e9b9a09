#pragma once

#include "IndexedMesh.h"
#include "Status.h"
#include "WindingNumbers.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// About `voxels` cubes along the axes of the world that cover a mesh with finite points and at
/// least two cubes around it.
VoxelCenters CubesAround(const IndexedMesh& mesh, double voxels);

/// 1 for the voxels whose centres are inside a mesh that faces outwards (winding number > 0), else
/// 0; i fastest. Of an open mesh, whose winding numbers depend on the direction in which they are
/// counted, those that are inside in at least four of the six directions along the grid's axes: a
/// hole misleads only the voxels behind it (after Nooruddin and Turk, "Simplification and repair of
/// polygonal models using volumetric techniques", IEEE TVCG 9, 2003). Fails as FindWindingNumbers
/// does.
Status FindInside(const IndexedMesh& mesh, const VoxelCenters& grid, bool isOpen,
                  std::vector<std::uint8_t>& inside);
} // namespace palpate
