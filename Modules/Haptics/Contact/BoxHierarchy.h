#pragma once

#include "Vector3.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Boxes within boxes, in one flat list: what lies near a place is found without looking at all.
/// Immutable. To make it takes some microseconds a box.
class BoxHierarchy
{
public:
  /// In the order of a walk: a node's first part follows it.
  struct Node
  {
    Eigen::AlignedBox3d Box; ///< holds all below
    std::int32_t Second = 0; ///< the other part; of a leaf 0
    std::int32_t First = 0;  ///< of a leaf, its first place in Order()
    std::int32_t Count = 0;  ///< of a leaf, how many boxes it has; else 0
  };
  /// Halving leaves no tree deeper than that.
  static constexpr int MostPending = 64;

  BoxHierarchy() = default;
  /// Halves of equal number along the longest side. No number may be NaN.
  explicit BoxHierarchy(const std::vector<Eigen::AlignedBox3d>& boxes);

  /// The first is the root; empty without boxes.
  const std::vector<Node>& Nodes() const noexcept { return this->Tree; }
  /// The numbers of the boxes, leaf by leaf.
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
