#pragma once

#include "CheckedMask.h"
#include "MaskStatistic.h"

#include <vector>

namespace palpate
{
/// Appends "neck": how thin the bridge to a second body of a part is, 1 - (depth of the bridge) /
/// (depth of the body), over the bodies that have a hundredth of the volume or more where they meet
/// the rest; at the bridge. `depths` (mm) are those of the voxels (DistanceToOthers); Amount is
/// twice the depth of the bridge, mm.
///
/// Voxels are added from the deepest on; two bodies meet at a saddle of the depth, and the
/// shallower one ends there (the persistence of maxima: Edelsbrunner, Letscher and Zomorodian,
/// Discrete Comput. Geom. 28, 2002). All erosions are so judged at once.
void MeasureNeck(const CheckedMask& part, const std::vector<float>& depths,
                 MaskStatistics& statistics);
} // namespace palpate
