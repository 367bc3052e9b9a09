#pragma once

#include "MeshSimplification.h"
#include "VertexRelaxation.h"

#include <cstddef>
#include <vector>

namespace palpate
{
/// Map to the sphere of the vertices that have returned to a simplified mesh so far. Every triangle
/// is positively oriented after each call.
class MapRefinement
{
public:
  /// `rings` is a tetrahedron, which is mapped to the regular one; both arguments are kept, and
  /// `vertices` have their points.
  MapRefinement(VertexRings& rings, std::vector<MappedVertex>& vertices);

  /// Vertices that have returned.
  std::size_t Size() const noexcept { return this->Present.size(); }

  /// Puts the vertex that was removed last of those still missing into the kernel of its ring.
  /// False if the kernel is thinner than rounding.
  bool Return(const MeshSimplification& simplification, const MeshSimplification::Removal& removal);
  /// Sweeps until the map hardly changes, or for about as long as vertices take to return.
  void SweepLevel();
  /// One fine sweep over the waiting vertices: those next to a change. False once all are at rest.
  bool Sweep();
  void WakeAll();

private:
  bool Sweep(double tolerance);
  void MakeRoom(Ring ring);
  void Wake(int vertex);
  void PlaceTetrahedron();

  VertexRings& Rings;
  std::vector<MappedVertex>& Vertices;
  VertexRelaxation Relaxation;
  std::vector<int> Present;
  std::vector<char> Waiting;
};
} // namespace palpate
