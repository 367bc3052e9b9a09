#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// Distances (mm) of the points of a surface from another one, weighted by the points' areas.
struct DistanceSummary
{
  double Mean = 0.0;
  double Rms = 0.0;
  double Percentile95 = 0.0; ///< least distance not exceeded on 95 % of the area
  double Largest = 0.0;
};

struct MeshDistances
{
  DistanceSummary OneToOther;
  DistanceSummary OtherToOne;
  DistanceSummary Both; ///< of both together, each side with half of the weight
};

/// A third of the area of the triangles around each point, mm^2. The indices must be valid.
std::vector<double> PointAreas(const IndexedMesh& mesh);

/// Unsigned distances from the points of each surface to the nearest point of the other; finite
/// triangles matter, so both need points as dense as their shape requires. Points without area have
/// no weight, but count for the largest distance. Fails as TriangleTree::Make does.
Status MeasureMeshDistances(const IndexedMesh& one, const IndexedMesh& other,
                            MeshDistances& distances);
} // namespace palpate
