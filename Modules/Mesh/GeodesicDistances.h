#pragma once

#include "KernelProgress.h"
#include "NearestOnMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// Lengths (mm) of the shortest paths along a surface from one of its points, `from`, to all points
/// of the mesh: exact for the triangles, to rounding; infinite where no path leads. Paths cross
/// edges of exactly two triangles, as those of SurfacePaths. Indices have to be valid and
/// triangles to have an area (SurfacePaths::Mesh).
///
/// Windows are propagated over the triangles in the order of their distance: Chen and Han,
/// "Shortest paths on a polyhedron" (1990), with the queue and the filter of Xin and Wang,
/// "Improving Chen and Han's algorithm on the discrete geodesic problem", ACM TOG 28 (2009). 16 s
/// for 128,000 triangles; time grows with the power 1.75 of their number.
///
/// Fails only if `progress` cancels.
Status FindGeodesicDistances(const IndexedMesh& mesh, const NearestOnMesh::Result& from,
                             const KernelProgress& progress, std::vector<double>& distances);

/// The triangles around the points that a shortest path passes closely: from a place back to where
/// the distances begin, at each point to the neighbour in whose direction they fall most.
std::vector<bool> CorridorBack(const IndexedMesh& mesh, const std::vector<double>& distances,
                               const NearestOnMesh::Result& from);
} // namespace palpate
