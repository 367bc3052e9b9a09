#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "Status.h"
#include "VoxelMask.h"

namespace palpate
{
/// The boundary of a mask as it is, half way between the centres of voxels inside and outside, in
/// world mm: closed, oriented outwards, with the surfaces of all parts and cavities.
/// Edges of the voxels' steps are bevelled between these middles. Voxels that share only an edge or
/// a corner are apart. Not interpolated between slices: for measurements against the mask itself.
/// Fails for a mask without voxels, and for more than a thousand million points.
Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary);
} // namespace palpate
