#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <vector>

class vtkPolyData;

namespace palpate
{
/// Intersection curves of a triangle surface and a plane, points in the surface's own frame.
/// vtkCutter and vtkStripper give the same curves but take seven to ten times as long (10 ms
/// instead of 1 for 8,000 triangles), and views cut every visible structure in three slices while
/// the crosshair moves. Several threads may cut the same surface at once.
struct SurfaceCurve
{
  std::vector<Vector3> Points;
  bool IsClosed = false;
};

PALPATEDISPLAY_EXPORT std::vector<SurfaceCurve>
CutSurface(vtkPolyData* surface, const Vector3& origin, const Vector3& normal);
} // namespace palpate
