#pragma once

#include "BoxHierarchy.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate
{
/// Which of many structures a tool may reach: the boxes in which its origin may touch each, so that
/// a tick looks at few. Immutable; Find is noexcept, allocates nothing, and takes time that grows
/// with what it finds and with the logarithm of what there is.
class ReachIndex
{
public:
  ReachIndex() = default;
  /// A box with NaN is met by nothing.
  explicit ReachIndex(const std::vector<Eigen::AlignedBox3d>& boxesWorld);

  /// Writes the numbers of all boxes that `boxWorld` meets, ascending, to where there is room for
  /// all; borders belong to boxes. Returns how many.
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
