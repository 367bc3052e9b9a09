#pragma once

#include "TopologyReport.h"
#include "VoxelMask.h"

namespace palpate
{
/// Removes parts (26 neighbours) that have less than the fraction `small` of the mask's voxels
/// each, if together they have more: a field loses them or drops them, and the surface of the rest
/// would be moved outwards to have their volume, too. Few of them stay, since those next to the
/// rest grow together with it. Places are in mm along the mask's axes from its first voxel's
/// centre.
TopologyChange DropSpecks(double small, VoxelMask& mask);
} // namespace palpate
