#pragma once

#include "FitResult.h"
#include "MappedSurface.h"
#include "PalpateFitModule.h"
#include "WindingNumbers.h"

#include <cstdint>
#include <vector>

namespace palpate
{
/// The voxels on which a model is compared with what was fitted.
struct ReferenceVoxels
{
  VoxelCenters Centers;
  std::vector<std::uint8_t> Inside; ///< 1 for those of the structure, i fastest
};

/// The mask's voxels in a box around the structure; of a surface file about a million cubes around
/// the surface.
PALPATEFIT_EXPORT ReferenceVoxels ReferenceVoxelsOf(const FitResult& result);
} // namespace palpate
