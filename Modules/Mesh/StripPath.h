#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// The shortest path within a strip of triangles, by unfolding it into a plane (funnel algorithm).
struct StripPath
{
  /// A corner of the strip that the path touches.
  struct Pivot
  {
    int Point;    ///< of the mesh
    int Crossing; ///< the last place in `crossed` whose edge the path meets there
  };

  std::vector<Vector3> Points; ///< ends, and where edges are crossed
  std::vector<Pivot> Pivots;   ///< in the order of the path
  double Length = 0.0;         ///< mm
};

/// `crossed` are the half-edges (see EdgeRings) through which the strip leaves its triangles in
/// turn; `entered` are those of the same edges in the next triangles. `from` lies in the first
/// triangle, `to` in the last one. Linear time, unless the strip is very winding.
StripPath FindStripPath(const IndexedMesh& mesh, const std::vector<int>& crossed,
                        const std::vector<int>& entered, const Vector3& from, const Vector3& to);
} // namespace palpate
