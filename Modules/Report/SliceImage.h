#pragma once

#include "GreyWindow.h"
#include "PalpateReportModule.h"
#include "RasterImage.h"
#include "SlicePlane.h"

#include <vector>

class vtkImageData;

namespace palpate
{
/// Values of an image at the centres of a plane's pixels, row by row from the top, linearly
/// interpolated; NaN outside. The image may have any grid: positions are in mm.
PALPATEREPORT_EXPORT std::vector<float> SampleLinear(vtkImageData* image, const SlicePlane& plane);

/// The same from the nearest voxel, for labels; 0 outside.
PALPATEREPORT_EXPORT std::vector<float> SampleNearest(vtkImageData* image, const SlicePlane& plane);

/// A plane's values in grey; NaN is black.
PALPATEREPORT_EXPORT RasterImage DrawGrey(const std::vector<float>& values, const SlicePlane& plane,
                                          const GreyWindow& window);
} // namespace palpate
