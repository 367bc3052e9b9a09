#pragma once

#include "IndexToWorld.h"
#include "IndexedMesh.h"
#include "Status.h"
#include "VoxelMask.h"

namespace palpate
{
/// The boundary of a mask as it is, half way between the centres of voxels inside and outside, in
/// world mm: closed, oriented outwards, with the surfaces of all parts and cavities. Not smoothed,
/// and not interpolated between slices: for measurements against the mask itself. Fails for a mask
/// without voxels, and for one whose surface has more than 2^31 points.
Status MakeMaskBoundary(const VoxelMask& mask, const IndexToWorld& toWorld, IndexedMesh& boundary);
} // namespace palpate
