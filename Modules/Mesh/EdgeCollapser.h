#pragma once

#include "HalfEdgeMesh.h"
#include "ReferenceNormals.h"

#include <vector>

namespace palpate
{
/// Replaces edges by points if that keeps the surface's topology and no triangle turns over. The
/// new point is the edge's midpoint, moved so that the enclosed volume stays the same (Lindstrom
/// and Turk, IEEE Visualization 1998).
class EdgeCollapser
{
public:
  EdgeCollapser(HalfEdgeMesh& mesh, ReferenceNormals& normals);

  /// Removes the point where h ends and moves the one where it starts. Returns false and changes
  /// nothing if the edge has to stay.
  bool TryCollapse(int h);

private:
  /// A triangle that stays but gets the new point: its other two points, and the old one.
  struct Wing
  {
    int From;
    int To;
    int Old;
  };

  bool HasTwoCommonNeighbours(int h);
  void CollectWings(int h);
  Vector3 NewPoint(int kept, int removed) const;
  bool StaysAligned(const Vector3& point, const Eigen::Vector3f& normal) const;

  HalfEdgeMesh& Mesh;
  ReferenceNormals& Normals;
  std::vector<Wing> Wings;
  std::vector<int> Stamps; ///< of each point, the last test in which it was a neighbour
  int Stamp = 0;
};
} // namespace palpate
