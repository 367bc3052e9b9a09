#pragma once

#include "PalpateSceneModule.h"
#include "ScanCut.h"
#include "Segmentation.h"

#include <vector>

namespace palpate
{
/// The faces of a segmentation's border that a structure reaches. A cut lies up to two voxels in
/// front of them, as in WithoutCut.
PALPATESCENE_EXPORT std::vector<ScanCut> CutsOf(const Segmentation& segmentation,
                                                const Segment& structure);
} // namespace palpate
