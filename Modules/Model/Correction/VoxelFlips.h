#pragma once

#include "CorrectionStep.h"
#include "IndexToWorld.h"
#include "MaskCorrection.h"
#include "Status.h"
#include "VoxelMask.h"

#include <array>
#include <vector>

namespace palpate
{
/// Where steps act that change few voxels: an image, and what they must not add.
struct VoxelGrid
{
  IndexToWorld ToWorld;
  std::array<int, 3> ImageSize{};
  MaskCorrection::Barrier Closed;
};

/// Whether a step is done by FindFlips: a stroke, an edit of voxels, a slice's copy or filling.
bool IsFlip(const CorrectionStep& step) noexcept;

/// The voxels of the grid that a step adds to a mask or removes from it. Fails as MakeStroke, for
/// voxels and slices beyond the image, and for slices without voxels that others are to be filled
/// from. Takes the time of the box around what the step is about, or of its slices.
Status FindFlips(const CorrectionStep& step, const VoxelGrid& grid, const VoxelMask& mask,
                 std::vector<IndexRun>& flips);

/// Adds the voxels that a mask lacks and removes those that it has; they are within its box, and
/// again undo it. Returns how many more it has.
long long Flip(const std::vector<IndexRun>& flips, VoxelMask& mask);
} // namespace palpate
