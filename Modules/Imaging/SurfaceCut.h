#pragma once

#include "PalpateImagingModule.h"
#include "Vector3.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// The curves in which a surface of triangles meets a plane, points in the surface's own frame.
/// Made here, and not by vtkCutter, because several threads cut the same surface at once.
struct SurfaceCurve
{
  std::vector<Vector3> Points;
  bool IsClosed = false;
};

PALPATEIMAGING_EXPORT std::vector<SurfaceCurve>
CutSurface(vtkPolyData* surface, const Vector3& origin, const Vector3& normal);
} // namespace palpate
