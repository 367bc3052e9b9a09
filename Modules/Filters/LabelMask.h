#pragma once

#include "PalpateFiltersModule.h"
#include "VoxelMask.h"

#include <algorithm>
#include <array>

class vtkImageData;

namespace palpate
{
/// The voxels of an image that have a label.
struct LabelMask
{
  VoxelMask Mask; ///< empty if there are none, or if the scalars are not of an integer type
  /// Whether it reaches the image's first and last i, j, k.
  std::array<bool, 6> TouchesFace{};
  bool TouchesBorder() const noexcept
  {
    return std::find(this->TouchesFace.begin(), this->TouchesFace.end(), true) !=
           this->TouchesFace.end();
  }
};

/// Copies the voxels with `label` and a margin of `rim` voxels around them.
PALPATEFILTERS_EXPORT LabelMask CopyLabelMask(vtkImageData* image, int label, int rim);
/// The same of one connected component (MaskComponents), numbered by descending size from 1; 0 for
/// all.
PALPATEFILTERS_EXPORT VoxelMask CopyComponent(vtkImageData* image, int label, int component,
                                              int rim);
} // namespace palpate
