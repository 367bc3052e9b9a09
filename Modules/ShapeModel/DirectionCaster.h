#pragma once

#include "PalpateShapeModelModule.h"
#include "Vector3.h"

#include <array>
#include <vector>

namespace palpate
{
/// A triangle mesh in arrays, as kernels take it.
struct IndexedMesh
{
  std::vector<Vector3> Points;
  std::vector<std::array<int, 3>> Triangles;
};

/// Where a ray crosses a triangle.
struct RayCrossing
{
  int Triangle;
  double Distance; ///< from the centre, in the mesh's unit
};

/// Finds every crossing of rays that share their start with a mesh. The directions are sorted into
/// the cells of a cube around the start once; each triangle then meets only the directions in the
/// cells that its projection covers.
///
/// Crossings are counted exactly once: triangles that share an edge use the same numbers for it,
/// and rays are turned by 1e-11 rad in a fixed odd direction, so that rays aimed at the vertices or
/// edges of a symmetric mesh decide for one side.
class PALPATESHAPEMODEL_EXPORT DirectionCaster
{
public:
  /// `directions` are unit vectors.
  explicit DirectionCaster(const std::vector<Vector3>& directions);

  /// The crossings of the ray from `center` along each direction, by rising distance.
  std::vector<std::vector<RayCrossing>> Cast(const IndexedMesh& mesh, const Vector3& center) const;

  /// For each direction, how many triangles other than its own (`ownTriangle`) cross the ray nearer
  /// to the centre than `distance`.
  std::vector<int> CountNearer(const IndexedMesh& mesh, const Vector3& center,
                               const std::vector<int>& ownTriangle,
                               const std::vector<double>& distance) const;

private:
  template <typename Visit>
  void ForEachCrossing(const IndexedMesh& mesh, const Vector3& center, const Visit& visit) const;
  template <typename Visit>
  void VisitFace(std::size_t face, const std::array<Vector3, 3>& corners, const Visit& visit) const;

  std::vector<Vector3> Directions; // turned, see above
  int CellsPerSide;
  // Directions of cell c: Order[CellStart[c]] .. Order[CellStart[c + 1] - 1].
  std::vector<std::size_t> CellStart;
  std::vector<std::size_t> Order;
};
} // namespace palpate
