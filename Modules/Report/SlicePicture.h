#pragma once

#include "GreyWindow.h"
#include "PalpateReportModule.h"
#include "Picture.h"
#include "SlicePlane.h"

#include <vector>

class vtkImageData;

namespace palpate
{
/// Values of an image at the middles of a plane's pixels, row by row from the top, linearly
/// interpolated; not a number outside. The image may lie on any grid: only millimetres count.
PALPATEREPORT_EXPORT std::vector<float> SampleLinear(vtkImageData* image, const SlicePlane& plane);

/// The same from the nearest voxel, for labels; 0 outside.
PALPATEREPORT_EXPORT std::vector<float> SampleNearest(vtkImageData* image, const SlicePlane& plane);

/// A plane's values in grey; what is not a number is black.
PALPATEREPORT_EXPORT Picture DrawGrey(const std::vector<float>& values, const SlicePlane& plane,
                                      const GreyWindow& window);
} // namespace palpate
