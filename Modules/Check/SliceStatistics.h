#pragma once

#include "CheckedMask.h"
#include "MaskStatistic.h"

namespace palpate
{
/// Appends what slices tell. Of all voxels, along the last axis: "gap" (empty slices between filled
/// ones: the smaller area next to them over the largest slice's; Amount: slices), "copied" (share
/// of neighbouring slices that are equal to 1 % of their area; Amount: the most that follow each
/// other) and "border" (faces at the image's border, mm^2, over the volume to the power 2/3;
/// Amount: mm^2).
void MeasureSlices(const CheckedMask& mask, MaskStatistics& statistics);

/// Of one part: "end_superior", "end_inferior" or what sides of the patient the last axis has (the
/// area of the last slice over that of the largest; Amount: percent), "edge_left", "edge_right", …
/// (the same of the other axes) and "step" (the largest difference between neighbouring slices
/// along the last axis, of those with a third of the largest area or more: voxels in one of the two
/// over the mean of their areas).
void MeasureEnds(const CheckedMask& part, MaskStatistics& statistics);
} // namespace palpate
