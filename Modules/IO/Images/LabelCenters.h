#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Vector3.h"

#include <map>

namespace palpate
{
/// A point inside each structure (world, mm), by label: the centre of its voxel that is nearest to
/// its centroid, which may itself lie outside, as of a crescent. Time does not grow with the number
/// of structures.
PALPATEIO_EXPORT std::map<int, Vector3> LabelCenters(const Segmentation& segmentation);
} // namespace palpate
