#pragma once

#include "EdgeRings.h"
#include "IndexedMesh.h"
#include "KernelProgress.h"
#include "NearestOnMesh.h"
#include "Status.h"

#include <memory>
#include <vector>

namespace palpate
{
struct StripPath;

/// Finds geodesics of a surface: paths along its triangles that no small change shortens.
/// Immutable; queries are thread-safe and allocate. Some 150 bytes per triangle.
///
/// A path is exact for the triangles, to rounding, but only the shortest one near that along the
/// midpoints of edges: of two routes around an obstacle that differ by some percent in length,
/// either may be found; FindShortest takes the shorter one. Where triangles of edge h approximate a
/// surface of radius of curvature R, its length is too small by some (h / R)^2 / 24.
class SurfacePaths
{
public:
  /// Points at equal positions are one. Fails as TriangleTree::Make does.
  static Status Make(IndexedMesh mesh, std::unique_ptr<const SurfacePaths>& made);

  struct Path
  {
    std::vector<Vector3> Points; ///< from end to end, where edges are crossed
    double Length = 0.0;         ///< mm
  };

  /// Between the surface's points that are nearest to these (mm, finite). Fails if they lie on
  /// parts that are not connected.
  Status Find(const Vector3& from, const Vector3& to, Path& found) const;
  /// The same near the shortest of all paths (FindGeodesicDistances), which is found but for routes
  /// that differ by less than an edge. A thousand times the time of Find; fails, too, if `progress`
  /// cancels.
  Status FindShortest(const Vector3& from, const Vector3& to, const KernelProgress& progress,
                      Path& found) const;

  const IndexedMesh& Mesh() const noexcept { return this->Surface; }
  const NearestOnMesh& Nearest() const noexcept { return this->Places; }

private:
  // Edges First..Last of a strip run around a point; Other ones pass it on its other side.
  struct Detour
  {
    int First;
    int Last;
    std::vector<int> Other;
  };

  SurfacePaths(IndexedMesh mesh, NearestOnMesh places);

  int AcrossOf(int halfEdge) const noexcept; // of the neighbour; -1 at a boundary
  Vector3 MiddleOf(int halfEdge) const noexcept;
  // Half-edges that lead from triangle to triangle, those of a corridor if there is one; empty if
  // there is no way.
  std::vector<int> Search(const NearestOnMesh::Result& from, const NearestOnMesh::Result& to,
                          const std::vector<bool>& corridor) const;
  Status FindIn(const NearestOnMesh::Result& from, const NearestOnMesh::Result& to,
                const std::vector<bool>& corridor, Path& found) const;
  StripPath PathOf(const std::vector<int>& crossed, const Vector3& from, const Vector3& to) const;
  bool RunsAround(int halfEdge, int point) const noexcept;
  Detour DetourAt(const std::vector<int>& crossed, int point, int place) const;
  StripPath Shorten(std::vector<int>& crossed, const Vector3& from, const Vector3& to) const;
  bool PassCorners(const StripPath& path, std::vector<int>& crossed) const;
  void CutEnds(std::vector<int>& crossed, const Vector3& from, const Vector3& to) const;
  void RemoveLoops(std::vector<int>& crossed) const;

  IndexedMesh Surface;
  EdgeRings Rings;
  NearestOnMesh Places;
};
} // namespace palpate
