#pragma once

#include "KernelProgress.h"
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
  /// The vertices of `rings` are mapped, or they are four: those are mapped to a regular
  /// tetrahedron. Both arguments are kept, and `vertices` have their points.
  MapRefinement(VertexRings& rings, std::vector<MappedVertex>& vertices);

  /// Vertices that have returned.
  std::size_t Size() const noexcept { return this->Present.size(); }

  /// Puts all removed vertices into the kernels of their rings, the last one first, and sweeps
  /// whenever their number has grown by half. False if a kernel is thinner than rounding, or if
  /// `progress` cancels.
  bool ReturnAll(const MeshSimplification& simplification, const KernelProgress& progress);
  /// MapDescent of all vertices, unless their energy is `enough` already; returns the energy.
  double Descend(int mostSteps, double enough);
  /// One fine sweep over the waiting vertices: those next to a change. False once all are at rest.
  bool Sweep();
  void WakeAll();

private:
  bool Return(const MeshSimplification& simplification, const MeshSimplification::Removal& removal);
  void SweepLevel();
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
