#pragma once

#include "DirectionCaster.h"
#include "PalpateFiltersModule.h"

#include <vector>

class vtkPoints;
class vtkPolyData;

namespace palpate
{
/// Unsigned distance (mm) of every point to the nearest point of a triangle surface; NaN if it has
/// no triangles or points that are not finite (NearestOnMesh).
PALPATEFILTERS_EXPORT std::vector<double> ClosestPointDistances(const std::vector<Vector3>& points,
                                                                const IndexedMesh& surface);
PALPATEFILTERS_EXPORT std::vector<double> ClosestPointDistances(vtkPoints* points,
                                                                vtkPolyData* surface);

/// The same for a closed surface, negative inside it.
PALPATEFILTERS_EXPORT std::vector<double> SignedDistances(const std::vector<Vector3>& points,
                                                          const IndexedMesh& surface);

/// Whether the point at a distance (mm) along a ray lies inside a closed surface, of which these
/// are the ray's crossings: the rest of the ray leaves it once more than it enters.
PALPATEFILTERS_EXPORT bool IsInside(const std::vector<RayCrossing>& crossings, double distance);
} // namespace palpate
