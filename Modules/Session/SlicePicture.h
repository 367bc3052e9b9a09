#pragma once

#include "PalpateSessionModule.h"
#include "Picture.h"
#include "SlicePlane.h"

#include <vector>

class vtkImageData;

namespace palpate
{
/// Values of an image at the middles of a plane's pixels, row by row from the top, linearly
/// interpolated; not a number outside. The image may lie on any grid: only millimetres count.
PALPATESESSION_EXPORT std::vector<float> SampleLinear(vtkImageData* image, const SlicePlane& plane);

/// The same from the nearest voxel, for labels; 0 outside.
PALPATESESSION_EXPORT std::vector<float> SampleNearest(vtkImageData* image,
                                                       const SlicePlane& plane);

/// Which values are black and which are white.
struct GreyWindow
{
  double Low = 0.0;
  double High = 1.0;
};

/// From the 1st to the 99.5th percentile of all finite values of some slices.
PALPATESESSION_EXPORT GreyWindow FindWindow(const std::vector<std::vector<float>>& slices);

/// A plane's values in grey; what is not a number is black.
PALPATESESSION_EXPORT Picture DrawGrey(const std::vector<float>& values, const SlicePlane& plane,
                                       const GreyWindow& window);
} // namespace palpate
