#pragma once

#include "ShapeField.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// The Freudenthal (Kuhn) triangulation of a grid: each cube is six tetrahedra around its diagonal
/// from the lowest to the highest corner, so a node has 14 neighbours. It is the same for the nodes
/// inside and outside of an object, whose boundary by marching tetrahedra is therefore always a
/// manifold, with the topology of the set of nodes inside.
/// Source: Freudenthal, "Simplizialzerlegungen von beschränkter Flachheit", Annals of Mathematics
/// 43 (1942).

/// Neighbour n < 7 is a step of 1 along the axes in the bits of n + 1 (bit 0: i); neighbour n + 7
/// is the opposite of n.
constexpr int KuhnNeighbors = 14;

constexpr std::array<int, 3> KuhnStep(int neighbor) noexcept
{
  const int bits = neighbor % 7 + 1;
  const int sign = neighbor < 7 ? 1 : -1;
  return {sign * (bits & 1), sign * (bits >> 1 & 1), sign * (bits >> 2)};
}

/// Steps to the neighbours in a grid's nodes.
using KuhnOffsets = std::array<std::ptrdiff_t, KuhnNeighbors>;
KuhnOffsets OffsetsOf(const ShapeGrid& grid);

/// For each set of neighbours inside, whether the node between them is simple: adding it to an
/// object or removing it changes no topology, because its neighbours inside and those outside are
/// both one connected part of its link, a triangulated sphere of 14 nodes. 2^14 bits, computed at
/// the first use of Get.
class SimpleNodes
{
public:
  static const SimpleNodes& Get();

  bool Contains(unsigned neighborsInside) const noexcept
  {
    return (this->Bits[neighborsInside >> 6] >> (neighborsInside & 63) & 1) != 0;
  }

private:
  SimpleNodes();

  std::array<std::uint64_t, (1 << KuhnNeighbors) / 64> Bits{};
};

/// Euler characteristic of the nodes inside (vertices - edges + triangles - tetrahedra whose nodes
/// are all inside): parts - handles + cavities. `inside` has 1 for nodes inside, 0 for others and
/// for all nodes of the grid's last layers.
long long EulerCharacteristic(const ShapeGrid& grid, const std::vector<unsigned char>& inside);
} // namespace palpate
