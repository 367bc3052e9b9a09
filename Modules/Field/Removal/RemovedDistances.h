#pragma once

#include "FieldGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// For each node of a grid the signed distance (mm) to all that tools have removed, negative
/// inside, held within a band round the surface of that: what is farther away counts as the band's
/// end.
///
/// Immutable: RemovalStroke makes the next one, which shares with the one before whatever did not
/// change. So any number of earlier states are kept at the memory of what changed between them, and
/// a state can be read by any number of threads.
class RemovedDistances
{
public:
  /// Nodes of a block along an axis.
  static constexpr int Side = 8;
  static constexpr int NodesOfBlock = Side * Side * Side;
  /// The lowest node of a block, as whole indices; multiples of Side.
  using Corner = std::array<int, 3>;

  /// Nothing removed yet. `band` (mm) > 0.
  static std::shared_ptr<const RemovedDistances> None(const FieldGrid& grid, double band);

  const FieldGrid& Grid() const noexcept { return this->Frame; }
  double Band() const noexcept { return this->Limit; }
  /// Whether both are of the same grid and band, to the last bit.
  bool IsLike(const RemovedDistances& other) const noexcept;

  /// Of a node of the grid.
  float At(int i, int j, int k) const noexcept;
  /// Nodes of a block, i fastest; nullptr where nothing is removed within the band. Nodes beyond
  /// the grid's border count for nothing.
  const float* BlockAt(const Corner& corner) const noexcept;

  /// Corners of the blocks that differ between two of the same grid. Blocks that they share cost
  /// nothing.
  static std::vector<Corner> Difference(const RemovedDistances& a, const RemovedDistances& b);

  /// Of all blocks that are kept, in the order of memory.
  std::vector<Corner> Corners() const;

  /// Of what is not shared with `other`; of everything without.
  std::size_t BytesBeside(const RemovedDistances* other) const noexcept;

private:
  static constexpr int PageSide = 8; // blocks
  struct Block
  {
    std::array<float, NodesOfBlock> Distances;
    float Most;          // of them
    std::uint32_t Depth; // of the state that it was made for
  };
  struct Page
  {
    std::array<std::shared_ptr<Block>, PageSide * PageSide * PageSide> Blocks;
    std::uint32_t Depth = 0;
  };
  friend class RemovalStroke;

  RemovedDistances(const FieldGrid& grid, double band);
  Block* Find(const Corner& corner) const noexcept;
  std::size_t PageNumber(const Corner& corner) const noexcept;
  static std::size_t BlockNumber(const Corner& corner) noexcept;
  Corner CornerOf(std::size_t page, std::size_t block) const noexcept;
  template <typename Visit>
  void ForEachDifference(const RemovedDistances& other, const Visit& visit) const;

  FieldGrid Frame;
  double Limit;
  std::array<int, 3> PageCounts{};
  /// States made on each other. What belongs to a state that is still in the making has its depth,
  /// and nobody else has it.
  std::uint32_t Depth = 0;
  std::vector<std::shared_ptr<Page>> Pages;
};
} // namespace palpate
