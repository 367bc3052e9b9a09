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

/// 1 for the voxels whose centres a mesh encloses, that is with a winding number other than 0
/// (lobes that a crossing turned inside out count too), else 0; i fastest. Of an open mesh, or
/// another whose winding numbers depend on the direction in which they are counted
/// (SurfaceTopology::IsConsistent), those that are inside in at least four of the six directions
/// along the grid's axes: a hole misleads only the voxels behind it (after Nooruddin and Turk,
/// "Simplification and repair of polygonal models using volumetric techniques", IEEE TVCG 9, 2003).
/// Fails as FindWindingNumbers does.
Status FindInside(const IndexedMesh& mesh, const VoxelCenters& grid, bool isConsistent,
                  std::vector<std::uint8_t>& inside);

/// The share, 0 to 1, of what a closed mesh encloses that it does not enclose just once: 0 unless
/// it crosses itself, has bodies that overlap or lie in each other, or is inside out. Counted on
/// some 200,000 cubes around it; 0 if they cannot be counted.
double IrregularShare(const IndexedMesh& mesh);
} // namespace palpate
