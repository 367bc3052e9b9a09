#pragma once

#include "IndexedMesh.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// A closed, oriented manifold of triangles that can be coarsened in place. Half-edge 4 t + k, k in
/// 0..2, runs from corner k of triangle t to the next corner; its twin runs back along the same
/// edge in the neighbour. 32 bytes per triangle and 28 per point.
class HalfEdgeMesh
{
public:
  /// Fails for points that are not finite or beyond 1e15 mm, invalid indices, and surfaces that are
  /// not closed, consistently oriented manifolds. Several parts and handles are allowed.
  static Status Make(const IndexedMesh& mesh, HalfEdgeMesh& made);

  static constexpr int Next(int h) noexcept { return (h & 3) == 2 ? h - 2 : h + 1; }
  static constexpr int Previous(int h) noexcept { return (h & 3) == 0 ? h + 2 : h - 1; }
  int Twin(int h) const noexcept { return this->Twins[h]; }
  int Start(int h) const noexcept { return this->Starts[h]; }
  int End(int h) const noexcept { return this->Starts[Next(h)]; }
  /// The next half-edge around the point where h starts.
  int Around(int h) const noexcept { return this->Twins[Previous(h)]; }
  /// A half-edge that starts at a point; -1 if the point was removed or is unused.
  int Leaving(int point) const noexcept { return this->Outgoing[point]; }
  /// Half-edges are numbered below this limit; IsAlive tells those that exist.
  int HalfEdgeLimit() const noexcept { return static_cast<int>(this->Starts.size()); }
  bool IsAlive(int h) const noexcept { return (h & 3) != 3 && this->Starts[h] >= 0; }
  int TriangleCount() const noexcept { return this->Count; }
  int PointCount() const noexcept { return static_cast<int>(this->Points.size()); }
  const Vector3& Point(int point) const noexcept { return this->Points[point]; }
  void Move(int point, const Vector3& to) noexcept { this->Points[point] = to; }

  /// Removes the two triangles of an edge and the point where h ends; its other triangles get the
  /// point where h starts. The two ends must have exactly two common neighbours and more than four
  /// triangles between them.
  void Collapse(int h) noexcept;
  /// Replaces the edge of h by the other diagonal of its two triangles, whose ends must not be
  /// joined yet, and whose old ends must keep three triangles.
  void Flip(int h) noexcept;

  /// Without removed triangles and points; the order is kept.
  IndexedMesh ToIndexedMesh() const;

private:
  Status LinkOutgoing();
  void Pair(int one, int other) noexcept
  {
    this->Twins[one] = other;
    this->Twins[other] = one;
  }

  std::vector<Vector3> Points;
  std::vector<int> Outgoing;
  std::vector<int> Starts;
  std::vector<int> Twins;
  int Count = 0;
};
} // namespace palpate
