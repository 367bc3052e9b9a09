#pragma once

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
/// A box of a grid's nodes along i, j, k; the last ones included.
struct NodeBox
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{};

  bool IsEmpty() const noexcept
  {
    return this->First[0] > this->Last[0] || this->First[1] > this->Last[1] ||
           this->First[2] > this->Last[2];
  }
  std::size_t Count() const noexcept
  {
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      count *= static_cast<std::size_t>(this->Last[axis] - this->First[axis] + 1);
    }
    return count;
  }
  /// Extends the box to contain another one.
  void Extend(const NodeBox& other) noexcept
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      this->First[axis] = std::min(this->First[axis], other.First[axis]);
      this->Last[axis] = std::max(this->Last[axis], other.Last[axis]);
    }
  }
  NodeBox CommonWith(const NodeBox& other) const noexcept
  {
    NodeBox common = *this;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      common.First[axis] = std::max(common.First[axis], other.First[axis]);
      common.Last[axis] = std::min(common.Last[axis], other.Last[axis]);
    }
    return common;
  }
};
} // namespace palpate
