#pragma once

#include "IndexToWorld.h"
#include "SurfaceBump.h"
#include "VoxelMask.h"

namespace palpate::test
{
/// The mask with its surface displaced by the bump around a centre (world, mm): where the bump
/// reaches, a voxel is inside if its centre, moved back by the bump, is inside the body between the
/// voxels: the zero level of the mask's shape field with the volume of its voxels
/// (MakeShapeField). Elsewhere the voxels stay. So a bump that is smaller than a voxel moves as
/// many voxels as its volume says. `mask` has a rim that holds the bump. Throws std::runtime_error.
VoxelMask WithBump(const VoxelMask& mask, const IndexToWorld& toWorld, const Vector3& centerWorld,
                   const SurfaceBump& bump);
} // namespace palpate::test
