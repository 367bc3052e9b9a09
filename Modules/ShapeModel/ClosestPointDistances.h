#pragma once

#include "PalpateShapeModelModule.h"

#include <vector>

class vtkPoints;
class vtkPolyData;

namespace palpate
{
/// Unsigned distance (mm) of every point to the nearest point of a triangle surface, by
/// vtkStaticCellLocator, on all threads.
PALPATESHAPEMODEL_EXPORT std::vector<double> ClosestPointDistances(vtkPoints* points,
                                                                   vtkPolyData* surface);

/// A third of the area of the triangles round each point (mm^2): what a point stands for in a mean
/// over the surface.
PALPATESHAPEMODEL_EXPORT std::vector<double> PointAreas(vtkPolyData* surface);
} // namespace palpate
