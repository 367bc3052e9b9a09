#pragma once

#include "FieldGrid.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace palpate
{
/// For each node of a grid the signed distance (mm) to the removed volume, negative inside, clamped
/// to a band around its surface.
///
/// Immutable: RemovalStroke creates the next state, which shares all unchanged parts with the
/// previous one. So earlier states cost only the memory of their differences, and any number of
/// threads may read a state.
class RemovedDistances
{
public:
  /// Nodes of a block along an axis.
  static constexpr int Side = 8;
  static constexpr int NodesOfBlock = Side * Side * Side;
  /// The lowest node of a block, as whole indices; multiples of Side.
  using Corner = std::array<int, 3>;

  /// Nothing removed. `band` (mm) > 0.
  static std::shared_ptr<const RemovedDistances> None(const FieldGrid& grid, double band);

  const FieldGrid& Grid() const noexcept { return this->Frame; }
  double Band() const noexcept { return this->Limit; }
  /// Whether grid and band are equal, to the last bit.
  bool IsLike(const RemovedDistances& other) const noexcept;

  /// Of a node of the grid.
  float At(int i, int j, int k) const noexcept;
  /// Nodes of a block, i fastest; nullptr if nothing is removed within the band. Nodes beyond the
  /// grid's border have no meaning.
  const float* BlockAt(const Corner& corner) const noexcept;

  /// Corners of the blocks that differ between two states of the same grid. Shared blocks take no
  /// time.
  static std::vector<Corner> Difference(const RemovedDistances& a, const RemovedDistances& b);

  /// Of all stored blocks, in memory order.
  std::vector<Corner> Corners() const;

  /// Memory that is not shared with `other`; all memory if it is nullptr.
  std::size_t BytesNotIn(const RemovedDistances* other) const noexcept;

private:
  static constexpr int PageSide = 8; // blocks
  struct Block
  {
    std::array<float, NodesOfBlock> Distances;
    float Most;          // largest distance in the block
    std::uint32_t Depth; // of the state for which it was created
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

  FieldGrid Frame;
  double Limit;
  std::array<int, 3> PageCounts{};
  /// Number of states before this one. Objects with the depth of a state under construction belong
  /// to it alone.
  std::uint32_t Depth = 0;
  std::vector<std::shared_ptr<Page>> Pages;
};
} // namespace palpate
