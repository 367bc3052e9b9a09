#pragma once

#include "IndexToWorld.h"
#include "SurfaceBump.h"
#include "VoxelMask.h"

namespace palpate::test
{
/// The mask's body with a bump around a centre (world, mm), on voxels that lie `shift` of a slice
/// further along the third axis than the mask's (-0.5 to 0.5): inside if the voxel's centre, moved
/// back by the bump where that reaches, is inside the level of the mask's shape field
/// (MakeShapeField) with the volume of its voxels. That level ends half way between the last slice
/// of the mask and the next one, so that unmoved slices show no bump of less than half a slice
/// along them, and all of a higher one; of slices that lie anywhere, as in patients, as many as the
/// bump's volume says. `mask` has a rim that holds the bump. Throws std::runtime_error.
VoxelMask WithBump(const VoxelMask& mask, const IndexToWorld& toWorld, const Vector3& centerWorld,
                   const SurfaceBump& bump, double shift);
} // namespace palpate::test
