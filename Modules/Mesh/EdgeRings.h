#pragma once

#include "IndexedMesh.h"

#include <vector>

namespace palpate
{
/// Whether a triangle has three different indices of points.
inline bool HasThreePoints(const std::array<int, 3>& triangle, std::size_t pointCount) noexcept
{
  const auto [a, b, c] = triangle;
  const int count = static_cast<int>(pointCount);
  return a >= 0 && b >= 0 && c >= 0 && a < count && b < count && c < count && a != b && b != c &&
         c != a;
}

/// The half-edges of every edge of a mesh. Half-edge 3 t + k runs from corner k of triangle t to
/// the next corner; those between the same two points, in either direction, form a ring. Triangles
/// without three different valid indices are left out. 4 bytes per half-edge; linear time, but for
/// points with many triangles, whose edges are sorted.
class EdgeRings
{
public:
  /// At most 700 million triangles.
  explicit EdgeRings(const IndexedMesh& mesh);

  /// The next half-edge of the same edge; itself on a boundary; -1 for a triangle left out.
  int Next(int halfEdge) const noexcept { return this->Rings[halfEdge]; }
  bool IsLeftOut(int triangle) const noexcept { return this->Rings[3 * triangle] < 0; }
  bool IsBoundary(int halfEdge) const noexcept { return this->Rings[halfEdge] == halfEdge; }
  /// Whether exactly two triangles use the edge.
  bool IsPair(int halfEdge) const noexcept
  {
    const int other = this->Rings[halfEdge];
    return other != halfEdge && this->Rings[other] == halfEdge;
  }
  int EdgeCount() const noexcept { return this->Edges; }

private:
  std::vector<int> Rings;
  int Edges = 0;
};

/// The half-edge that follows within the triangle, and the one before.
constexpr int NextInTriangle(int halfEdge) noexcept
{
  return halfEdge % 3 == 2 ? halfEdge - 2 : halfEdge + 1;
}
constexpr int PreviousInTriangle(int halfEdge) noexcept
{
  return halfEdge % 3 == 0 ? halfEdge + 2 : halfEdge - 1;
}
/// The point where a half-edge starts.
inline int StartOf(const IndexedMesh& mesh, int halfEdge) noexcept
{
  return mesh.Triangles[halfEdge / 3][halfEdge % 3];
}
} // namespace palpate
