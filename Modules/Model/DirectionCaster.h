#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
struct RayCrossing
{
  int Triangle;
  double Distance; ///< from the centre, in the mesh's unit
};

/// Finds all intersections of a mesh with rays from one origin. The directions are sorted once into
/// the cells of a cube around the origin; each triangle is then tested only against directions in
/// the cells that its projection covers.
///
/// Crossings are counted exactly once: triangles that share an edge use the same numbers for it,
/// and rays are rotated by 1e-11 rad about a fixed oblique axis, so that rays aimed at the vertices
/// or edges of a symmetric mesh hit exactly one side.
class DirectionCaster
{
public:
  /// `directions` are unit vectors.
  explicit DirectionCaster(const std::vector<Vector3>& directions);

  /// Crossings of the ray from `center` along each direction, by increasing distance.
  std::vector<std::vector<RayCrossing>> Cast(const IndexedMesh& mesh, const Vector3& center) const;

  /// For each direction, the number of triangles other than its own (`ownTriangle`) that cross the
  /// ray closer to the centre than `distance`.
  std::vector<int> CountNearer(const IndexedMesh& mesh, const Vector3& center,
                               const std::vector<int>& ownTriangle,
                               const std::vector<double>& distance) const;

private:
  template <typename Visit>
  void ForEachCrossing(const IndexedMesh& mesh, const Vector3& center, const Visit& visit) const;
  template <typename Visit>
  void VisitFace(std::size_t face, const std::array<Vector3, 3>& corners, const Visit& visit) const;

  std::vector<Vector3> Directions; // rotated, see above
  int CellsPerSide;
  // Directions of cell c: Order[CellStart[c]] .. Order[CellStart[c + 1] - 1].
  std::vector<std::size_t> CellStart;
  std::vector<std::size_t> Order;
};
} // namespace palpate
