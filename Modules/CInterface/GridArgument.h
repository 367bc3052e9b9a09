#pragma once

#include "IndexToWorld.h"
#include "Status.h"
#include "VoxelMask.h"

#include <cstdint>

namespace palpate
{
/// Places a grid whose axes may be left-handed. Fails for one without voxels, and for an origin, a
/// spacing or axes that describe no grid.
Status PlaceGrid(const int size[3], const double origin[3], const double spacing[3],
                 const double axes[9], IndexToWorld& toWorld);

/// Throws InputError if the machine cannot hold a byte for each voxel: then the size is wrong.
void CheckVoxels(const int size[3]);

/// What is inside (not 0), with a voxel around it; empty if there is nothing.
/// Throws InputError as CheckVoxels does.
VoxelMask CroppedMask(const std::uint8_t* inside, const int size[3], const double spacing[3]);
} // namespace palpate
