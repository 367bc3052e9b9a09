#pragma once

#include "IndexedMesh.h"
#include "InstructionSet.h"
#include "Status.h"
#include "TriangleTree.h"

#include <array>
#include <vector>

namespace palpate
{
/// Finds the nearest point of a mesh; unsigned, the mesh may be open. Immutable; queries are
/// thread-safe and do not allocate. 60 bytes per triangle.
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

  /// The same for many finite points: in spatial order and several at a time, which takes a third
  /// of the time.
  std::vector<Result> FindAll(const std::vector<Vector3>& points,
                              InstructionSet set = FastestInstructionSet()) const;
  /// The distances (mm) alone.
  std::vector<double> DistancesOf(const std::vector<Vector3>& points,
                                  InstructionSet set = FastestInstructionSet()) const;

private:
  using Corners = std::array<int, 3>;

  void Arrange(const IndexedMesh& mesh);
  void Search(const std::vector<Vector3>& points, InstructionSet set, std::vector<double>& squares,
              std::vector<int>& places) const;
  Corners Segment(const Corners& flat) const;
  bool IsFlat(const Corners& corners) const;

  std::vector<TriangleTree::Node> Nodes;
  std::vector<int> Order;         // the number in the mesh of each triangle, leaf by leaf
  std::vector<int> Places;        // in that order, of each triangle
  std::vector<Corners> Triangles; // in that order
  std::vector<Vector3> Points;    // of the triangles, in that order
};

/// The nearest point of the triangle a, b, c (Ericson, Real-Time Collision Detection, 2005, 5.1.5).
Vector3 NearestOnTriangle(const Vector3& point, const Vector3& a, const Vector3& b,
                          const Vector3& c) noexcept;
} // namespace palpate
