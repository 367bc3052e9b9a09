#pragma once

#include "PalpateImagingModule.h"
#include "Vector3.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// A curve in which a surface of triangles meets a plane, points in the surface's own frame.
struct SurfaceCurve
{
  std::vector<Vector3> Points;
  bool IsClosed = false;
};

/// Cuts by vtkCutter, on a copy that shares the arrays: threads may cut the same surface at once.
PALPATEIMAGING_EXPORT std::vector<SurfaceCurve>
CutSurface(vtkPolyData* surface, const Vector3& origin, const Vector3& normal);
} // namespace palpate
