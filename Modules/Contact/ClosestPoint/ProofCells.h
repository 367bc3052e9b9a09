#pragma once

#include "ClosestPointDescent.h"
#include "ClosestPointSearch.h"
#include "MovedBounds.h"
#include "QuarteredCells.h"
#include "SphericalTriangle.h"
#include "SurfaceKind.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

namespace palpate
{
/// The cells of a ClearanceProof, which cover the parameters of a surface, with their bounds: nodes
/// of the search's tree, and triangles within its finest nodes. Four siblings are a group. Memory
/// is fixed.
template <typename Surface>
struct ProofCells
{
  static constexpr int None = -1;
  static constexpr std::size_t Count = MovedBounds::Count; // of a group
  static constexpr std::size_t Groups = SurfaceKind<Surface>::ProofCells / Count;
  static constexpr std::size_t Capacity = Count * Groups;

  struct Triangle
  {
    int Leaf; // of those that are a whole node, else None
    bool IsEvaluated;
    SphericalTriangle Corners; // without a leaf
    SphericalCap Cap;
    SampleOf<Surface> Sample; // at the cap's centre
    typename ClosestPointDescentOf<Surface>::CapBounds Bounds;
  };

  /// The roots of the tree, without bounds. Keeps the search's address, which must outlive it.
  void Begin(const ClosestPointSearchOf<Surface>& search) noexcept;
  /// Joins groups with more clearance than `far`: the many cells that were quartered for places
  /// left behind.
  void Join(double far) noexcept;
  double LeastOf(std::size_t group) const noexcept
  {
    const double* until = &this->ClearUntil[Count * group];
    return std::min(std::min(until[0], until[1]), std::min(until[2], until[3]));
  }
  /// The parts of a cell take its place, with its clearance: of a node that is not a finest one,
  /// and of a triangle. Returns their group; Groups without memory.
  std::size_t CutNode(std::size_t index) noexcept;
  std::size_t CutTriangle(std::size_t index) noexcept;
  /// Makes a triangle of a finest node.
  void Separate(std::size_t index) noexcept;
  const SphericalCap& CapOf(std::size_t index) const noexcept
  {
    const int node = this->Nodes[index];
    return node != None ? this->Search->Tree().CapOf(node) : this->Triangles[index].Cap;
  }
  /// Evaluates the surface for a triangle.
  void Evaluate(std::size_t index) noexcept;

  // No point of a cell is closer than this plus what the proof needs, minus the path length.
  // Infinite for cells that are quartered and for numbers without a cell.
  alignas(sizeof(FourLanes)) std::array<double, Capacity> ClearUntil;
  std::array<MovedBounds, Groups> Bounds;
  std::array<int, Groups> FirstNodes; // None for groups of triangles
  std::array<int, Capacity> Nodes;    // None for triangles
  std::array<Triangle, Capacity> Triangles;
  QuarteredCells<Groups> Parts;

private:
  void BeginGroup(std::size_t group, int firstNode, double clearUntil) noexcept;
  std::size_t Quarter(std::size_t index, int firstNode) noexcept;

  const ClosestPointSearchOf<Surface>* Search = nullptr;
};
} // namespace palpate
