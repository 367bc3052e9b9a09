#pragma once

#include "CheckedMask.h"
#include "Segmentation.h"

namespace palpate
{
/// The structure against which the island of another one lies: that whose voxels share the largest
/// area of faces with it. An island is the second largest part of the voxels, of which those that
/// share a corner are joined. Null if it touches none. `mask` is that of `structure`, with a rim of
/// one voxel; layers have one grid.
const Segment* NeighbourOfIsland(const Segmentation& labels, const Segment& structure,
                                 const CheckedMask& mask);
} // namespace palpate
