#pragma once

#include "CorrectionStep.h"
#include "IndexToWorld.h"
#include "Status.h"
#include "VoxelMask.h"

#include <array>
#include <functional>
#include <vector>

namespace palpate
{
/// The voxels of a stroke, in a box with a rim that has the stroke's size, not the image's: those
/// of the image whose centres are within the radius of the path. Of a brush in a slice: those that
/// the slice's plane passes through, with the distance within the plane. World mm, patient LPS.
/// Fails for a path without points or with more than MostPoints, numbers that are not finite or
/// beyond the limits, and after 1e9 tests. Allocates; some 2 ns for each voxel of the box around
/// each segment.
Status MakeStroke(const BrushStroke& stroke, const IndexToWorld& toWorld,
                  const std::array<int, 3>& imageSize, VoxelMask& made);

/// The value of an image at a voxel of the mask's grid; NaN where there is none.
using ValueAtVoxel = std::function<double(const std::array<int, 3>& index)>;

/// The same, ended at edges of an image: the stroke grows from its start over faces of its voxels
/// whose values are like those at the start. These are the voxels within half the radius of the
/// first point, or 1.5 voxels; like them is what differs from their median by no more than three
/// standard deviations, estimated by 1.4826 times the median absolute deviation, or if that is 0 by
/// 1.2533 times the mean one (Iglewicz and Hoaglin, How to Detect and Handle Outliers, 1993).
/// Single voxels left out between these are noise and belong to them.
Status MakeStrokeToEdges(const BrushStroke& stroke, const IndexToWorld& toWorld,
                         const std::array<int, 3>& imageSize, const ValueAtVoxel& value,
                         VoxelMask& made);

/// A mask's voxels, in the order of its box.
std::vector<IndexRun> ImageRunsOf(const VoxelMask& mask);
} // namespace palpate
