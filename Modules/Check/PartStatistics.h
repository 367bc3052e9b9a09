#pragma once

#include "CheckedMask.h"
#include "MaskStatistic.h"

namespace palpate
{
/// Appends "part" (share of the volume outside of the largest part; voxels that share a corner are
/// joined), "hole" (what the voxels
/// enclose, also where only edges or corners close it, over the volume) and "slice_hole" (what the
/// voxels enclose within slices along the last axis, over the volume), each with the volume (mm^3)
/// of the largest one and its centroid. `largest` gets the largest part; empty for a mask without
/// voxels.
void MeasureParts(const CheckedMask& mask, MaskStatistics& statistics, CheckedMask& largest);
} // namespace palpate
