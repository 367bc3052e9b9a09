#pragma once

#include "PalpateShapeModule.h"

#include <vector>

class vtkPoints;
class vtkPolyData;

namespace palpate
{
/// Unsigned distance (mm) of every point to the nearest point of a triangle surface, by
/// vtkStaticCellLocator; multithreaded.
PALPATESHAPE_EXPORT std::vector<double> ClosestPointDistances(vtkPoints* points,
                                                              vtkPolyData* surface);

/// A third of the area of the triangles around each point (mm^2): the point's weight in a mean over
/// the surface.
PALPATESHAPE_EXPORT std::vector<double> PointAreas(vtkPolyData* surface);
} // namespace palpate
