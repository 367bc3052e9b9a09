#pragma once

#include "BoxHierarchy.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Spatial index of the structures that a tool may reach: boxes in which its origin may touch each,
/// so that a tick examines few. Immutable; Find is noexcept, does not allocate, and its time grows
/// with the number of results and the logarithm of the number of structures.
class ReachIndex
{
public:
  ReachIndex() = default;
  /// A box with NaN intersects nothing.
  explicit ReachIndex(const std::vector<Eigen::AlignedBox3d>& boxesWorld);

  /// Writes the indices of all boxes that intersect `boxWorld`, ascending, to an array with room
  /// for all; borders belong to boxes. Returns their number.
  std::size_t Find(const Eigen::AlignedBox3d& boxWorld, std::uint32_t* found) const noexcept;

  std::size_t Bytes() const noexcept
  {
    return this->Hierarchy.Bytes() + this->Entries.size() * sizeof(Entry);
  }

private:
  struct Entry
  {
    Eigen::AlignedBox3d Box;
    std::uint32_t Number;
  };

  BoxHierarchy Hierarchy;
  std::vector<Entry> Entries; // leaf by leaf
};
} // namespace palpate
