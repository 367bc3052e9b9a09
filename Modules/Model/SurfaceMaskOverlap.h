#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "VoxelMask.h"
#include "WindingNumbers.h"

namespace palpate
{
/// Compares a closed surface (world mm) with a mask on the mask's own grid: a voxel belongs to the
/// surface if its centre lies inside (winding number > 0). Voxels beyond the mask's box count as
/// well, up to `mostVoxels` together; those of a surface that reaches farther are estimated from
/// its volume. A surface with coordinates that are not finite encloses nothing.
WindingOverlap OverlapOfSurfaceAndMask(const IndexedMesh& surface, const VoxelMask& mask,
                                       const IndexToWorld& toWorld, double mostVoxels);
} // namespace palpate
