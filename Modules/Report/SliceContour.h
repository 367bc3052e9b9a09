#pragma once

#include "PalpateReportModule.h"
#include "SlicePlane.h"

#include <string>

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// Where a surface of triangles (mm, patient LPS) cuts a plane, as the data of an SVG path in
/// picture coordinates; closed curves end with "Z". Empty where it does not. Const and thread-safe.
PALPATEREPORT_EXPORT std::string SurfaceContourPath(vtkPolyData* surface, const SlicePlane& plane);

/// The edges between voxels with and without `value` in the slice of `mask` that `plane` was chosen
/// from, as the data of an SVG path.
PALPATEREPORT_EXPORT std::string MaskOutlinePath(vtkImageData* mask, int value,
                                                 const SlicePlane& plane);
} // namespace palpate
