#pragma once

#include "FieldGrid.h"

#include <algorithm>
#include <array>
#include <cmath>
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
  /// Whether there are nodes to interpolate between along every axis.
  bool HasCells() const noexcept
  {
    return this->First[0] < this->Last[0] && this->First[1] < this->Last[1] &&
           this->First[2] < this->Last[2];
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

/// The box along the grid's axes (continuous indices) that contains a box in the world (mm).
inline Eigen::AlignedBox3d IndexBounds(const FieldGrid& grid,
                                       const Eigen::AlignedBox3d& boxWorld) noexcept
{
  Eigen::AlignedBox3d index;
  for (int n = 0; n < 8; ++n)
  {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(n);
    index.extend(grid.PointIndex(boxWorld.corner(corner)));
  }
  return index;
}

/// The box in the world (mm) that contains one along the grid's axes (continuous indices).
inline Eigen::AlignedBox3d WorldBounds(const FieldGrid& grid,
                                       const Eigen::AlignedBox3d& boxIndex) noexcept
{
  Eigen::AlignedBox3d world;
  for (int n = 0; n < 8; ++n)
  {
    const auto corner = static_cast<Eigen::AlignedBox3d::CornerType>(n);
    world.extend(grid.PointWorld(boxIndex.corner(corner)));
  }
  return world;
}

/// The nodes needed to interpolate within a box in the world (mm), and `margin` more on each side,
/// clipped to the grid.
inline NodeBox NodesRound(const FieldGrid& grid, const Eigen::AlignedBox3d& boxWorld,
                          double margin) noexcept
{
  const Eigen::AlignedBox3d index = IndexBounds(grid, boxWorld);
  NodeBox nodes;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    const double end = grid.Size()[axis] - 1;
    nodes.First[axis] = static_cast<int>(std::clamp(std::floor(index.min()[a]) - margin, 0.0, end));
    nodes.Last[axis] = static_cast<int>(std::clamp(std::ceil(index.max()[a]) + margin, 0.0, end));
  }
  return nodes;
}

/// The part of a grid with these nodes.
inline FieldGrid PartOf(const FieldGrid& grid, const NodeBox& nodes)
{
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = nodes.Last[axis] - nodes.First[axis] + 1;
  }
  const Vector3 first(nodes.First[0], nodes.First[1], nodes.First[2]);
  return {size, grid.PointWorld(first), grid.Spacing(), grid.Direction()};
}
} // namespace palpate
