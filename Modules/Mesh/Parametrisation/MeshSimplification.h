#pragma once

#include "KernelProgress.h"
#include "MappedVertex.h"
#include "VertexRings.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Order in which half-edge collapses take a triangulation down to a few vertices.
struct MeshSimplification
{
  /// No vertex with more neighbours is removed; every triangulation has one with at most five.
  static constexpr int LargestRing = 12;

  /// A removed vertex; its ring began with the neighbour that it collapsed to.
  struct Removal
  {
    int Vertex;
    int Count;
    std::size_t First; ///< in RingEntries
  };

  const int* RingOf(const Removal& removal) const noexcept
  {
    return this->RingEntries.data() + removal.First;
  }

  std::vector<Removal> Removals; ///< in order of removal
  std::vector<int> RingEntries;
};

struct SimplificationSettings
{
  int Vertices = 4; ///< that are left; a tetrahedron is the least
  /// Adds this share to a collapse's cost for each earlier change of the vertex's ring.
  double ChangePenalty = 0.1;
};

/// Collapses `rings` to a few vertices, cheapest first; the points' scale is arbitrary. The cost of
/// a collapse is the squared length of its edge, times penalties of the valence that it makes and
/// of earlier changes of the vertex's ring, so that no region is thinned out before others. Ties go
/// to the lower index; costs are compared after rounding to 16 bits, so that rotated or moved
/// copies of a mesh are simplified in the same order. O(n log n). False if `progress` cancels.
bool Simplify(const std::vector<MappedVertex>& vertices, const SimplificationSettings& settings,
              const KernelProgress& progress, VertexRings& rings, MeshSimplification& result);
} // namespace palpate
