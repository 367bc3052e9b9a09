#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <cstdint>
#include <vector>

namespace palpate
{
struct MeshCrossing
{
  int First; ///< the triangles, First < Second
  int Second;
  Vector3 Place; ///< within the boxes of both triangles
};

struct MeshCrossings
{
  std::int64_t Count = 0;          ///< of pairs of triangles that cross
  bool IsComplete = true;          ///< false if the search ended at the largest count
  std::vector<MeshCrossing> Pairs; ///< the first of them up to the limit, in ascending order
  int FlatTriangles = 0;           ///< without area, exactly; not tested
};

struct CrossingLimits
{
  std::size_t Pairs = 100;        ///< listed
  std::int64_t Count = 1'000'000; ///< after which the search ends
};

/// The pairs of triangles of a mesh that have more in common than corners or an edge: crossings,
/// touches, and neighbours folded onto each other. The decision is exact (TrianglesCross), for
/// coordinates rounded to 0 below 1e-70 mm. The mesh may be open, and points are the same only by
/// index. Fails as TriangleTree::Make does.
Status FindMeshCrossings(const IndexedMesh& mesh, const CrossingLimits& limits,
                         MeshCrossings& found);
} // namespace palpate
