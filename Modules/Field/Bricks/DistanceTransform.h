#pragma once

#include "VoxelMask.h"

#include <vector>

namespace palpate
{
/// Neighbours along which a distance may be measured.
enum class DistanceDomain
{
  AcrossI, ///< within the slice across the first axis,
  AcrossJ, ///< the second,
  AcrossK, ///< the third
  Space
};

/// Exact Euclidean distance (mm) between voxel centres, for each voxel of the mask that has
/// `value`, to the nearest voxel with another value; 0 for the others. Infinite if there is none.
/// Source: Felzenszwalb and Huttenlocher, "Distance transforms of sampled functions", Theory of
/// Computing 8 (2012): along each axis in turn, the lower envelope of parabolas.
std::vector<float> DistanceToOthers(const VoxelMask& mask, unsigned char value,
                                    DistanceDomain domain);

/// For each voxel the distance (mm) from its centre to the label's boundary, positive inside;
/// distances run between voxel centres, and the boundary lies `halfStep` from the last one.
std::vector<float> SignedDistances(const VoxelMask& mask, DistanceDomain domain, double halfStep);
} // namespace palpate
