#pragma once

#include "Vector3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// A bounding-volume hierarchy of boxes in one flat list. Immutable. Construction takes some
/// microseconds per box.
class BoxHierarchy
{
public:
  /// In depth-first order: a node's first child follows it.
  struct Node
  {
    Eigen::AlignedBox3d Box; ///< contains all boxes below
    std::int32_t Second = 0; ///< the other child; 0 for a leaf
    std::int32_t First = 0;  ///< of a leaf, its first index in Order()
    std::int32_t Count = 0;  ///< of a leaf, its number of boxes; else 0
  };
  /// No deeper tree results from halving.
  static constexpr int MostPending = 64;

  BoxHierarchy() = default;
  /// Splits into halves of equal number along the longest side. No number may be NaN.
  explicit BoxHierarchy(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// The first is the root; empty without boxes.
  const std::vector<Node>& Nodes() const noexcept { return this->Tree; }
  /// The indices of the boxes, leaf by leaf.
  const std::vector<std::uint32_t>& Order() const noexcept { return this->Numbers; }

  std::size_t Bytes() const noexcept
  {
    return this->Tree.size() * sizeof(Node) + this->Numbers.size() * sizeof(std::uint32_t);
  }

private:
  void Build(const std::vector<Eigen::AlignedBox3d>& boxes, const std::vector<Vector3>& centers,
             std::size_t begin, std::size_t end);

  std::vector<Node> Tree;
  std::vector<std::uint32_t> Numbers;
};
} // namespace palpate
