#pragma once

#include "PalpateDisplayModule.h"

#include <vector>

class vtkImageData;

namespace palpate
{
/// Window of grey values: Low is black, High is white.
struct GreyWindow
{
  double Low = 0.0;
  double High = 1.0;
};

/// From the 1st to the 99.5th percentile of all finite values of some slices.
PALPATEDISPLAY_EXPORT GreyWindow FindWindow(const std::vector<std::vector<float>>& slices);

/// The same for a whole image, from some of its voxels (their first component).
PALPATEDISPLAY_EXPORT GreyWindow WindowOf(vtkImageData* image);
} // namespace palpate
