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

/// Distance (mm) of every voxel centre from the mask's boundary, positive inside, which lies
/// `halfStep` (mm) from the last centre on either side.
std::vector<float> SignedDistance(const VoxelMask& mask, DistanceDomain domain, double halfStep);

/// Distances cut off at `bound` (mm) on either side.
std::vector<float> BoundedDistances(std::vector<float> distances, double bound);
} // namespace palpate
