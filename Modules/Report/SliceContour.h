#pragma once

#include "PalpateReportModule.h"
#include "SlicePlane.h"

#include <string>

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// The intersection of a triangle surface (mm, patient LPS) and a plane, as the data of an SVG path
/// in image coordinates; closed curves end with "Z". Empty if they do not intersect. Const and
/// thread-safe.
PALPATEREPORT_EXPORT std::string SurfaceContourPath(vtkPolyData* surface, const SlicePlane& plane);

/// The edges between voxels with and without `value` in `plane`'s slice of `mask`, as the data of
/// an SVG path.
PALPATEREPORT_EXPORT std::string MaskOutlinePath(vtkImageData* mask, int value,
                                                 const SlicePlane& plane);
} // namespace palpate
