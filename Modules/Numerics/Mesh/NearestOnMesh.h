#pragma once

#include "IndexedMesh.h"
#include "InstructionSet.h"
#include "Status.h"
#include "TriangleTree.h"

#include <vector>

namespace palpate
{
/// Finds the nearest point of a mesh; unsigned, the mesh may be open. Immutable; queries are
/// thread-safe and do not allocate. 134 bytes per triangle.
class NearestOnMesh
{
public:
  struct Result
  {
    Vector3 Point = Vector3::Zero();
    double Distance = 0.0; ///< mm
    int Triangle = 0;      ///< one of the nearest
  };

  /// Fails as TriangleTree::Make does. Triangles without area count as segments.
  static Status Make(const IndexedMesh& mesh, NearestOnMesh& made);

  /// The point (mm) must be finite.
  Result Find(const Vector3& point) const noexcept { return this->FindFrom(point, 0); }
  /// The same, faster if the triangle `start` is close to the point.
  Result FindFrom(const Vector3& point, int start) const noexcept;

  /// Distances (mm) of the points, which must be finite, in an order that lists each of them once:
  /// several at a time, three times as fast where points that follow each other there are close.
  std::vector<double> Distances(const std::vector<Vector3>& points, const std::vector<int>& order,
                                InstructionSet set = FastestInstructionSet()) const;

  /// The points of the mesh that this was made of, those of a triangle and its neighbours close to
  /// each other.
  static std::vector<int> PointOrder(const IndexedMesh& mesh, const NearestOnMesh& made);

private:
  struct Corners
  {
    Vector3 A;
    Vector3 B;
    Vector3 C;
  };

  static Corners Segment(const Corners& flat);

  TriangleTree Tree;
  std::vector<Corners> Triangles; // in the order of the tree
  std::vector<int> Places;        // in that order, of each triangle
};

/// The nearest point of the triangle a, b, c (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Vector3 NearestOnTriangle(const Vector3& point, const Vector3& a, const Vector3& b,
                          const Vector3& c) noexcept;
} // namespace palpate
