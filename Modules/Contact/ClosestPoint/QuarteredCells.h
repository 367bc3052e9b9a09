#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Numbers for cells that are quartered and joined again. Cells are numbered in groups of four: the
/// parts of a cell are a group, and so are four cells that are whole from the beginning. Memory is
/// fixed.
template <std::size_t Groups>
class QuarteredCells
{
public:
  static constexpr std::size_t Capacity = 4 * Groups;
  static constexpr std::size_t None = Groups;

  /// With so many groups of whole cells.
  void Begin(std::size_t whole) noexcept
  {
    this->Whole = whole;
    this->Used = whole;
    this->FreeCount = 0;
    this->Parts.fill(Unsplit);
  }
  /// Groups have smaller numbers than this.
  std::size_t End() const noexcept { return this->Used; }
  std::size_t FreeGroups() const noexcept { return Groups - this->Used + this->FreeCount; }

  /// Returns the group of the parts; None without a free one.
  std::size_t Quarter(std::size_t cell) noexcept
  {
    if (this->FreeGroups() == 0)
    {
      return None;
    }
    const std::size_t group = this->FreeCount > 0 ? this->Free[--this->FreeCount] : this->Used++;
    this->Parts[cell] = static_cast<std::uint16_t>(group);
    this->Parent[group] = static_cast<std::uint16_t>(cell);
    return group;
  }
  /// Joins groups of parts that `mayJoin(group)` accepts and of which none is quartered; then calls
  /// `joined(cell, group)`. One pass: cells that are joined may be parts of others.
  template <typename MayJoin, typename Joined>
  void Join(const MayJoin& mayJoin, const Joined& joined) noexcept
  {
    for (std::size_t group = this->Used; group-- > this->Whole;)
    {
      const std::size_t cell = this->Parent[group];
      if (this->Parts[cell] == group && !this->HasQuartered(group) && mayJoin(group))
      {
        this->Parts[cell] = Unsplit;
        this->Free[this->FreeCount++] = static_cast<std::uint16_t>(group);
        joined(cell, group);
      }
    }
  }

private:
  static constexpr std::uint16_t Unsplit = 0xffff;
  static_assert(Capacity < Unsplit, "cells are numbered by 16 bits");

  bool HasQuartered(std::size_t group) const noexcept
  {
    bool has = false;
    for (std::size_t part = 4 * group; part < 4 * group + 4; ++part)
    {
      has = has || this->Parts[part] != Unsplit;
    }
    return has;
  }

  std::array<std::uint16_t, Capacity> Parts; // group of a cell's parts
  std::array<std::uint16_t, Groups> Parent;  // cell of which a group is the parts
  std::array<std::uint16_t, Groups> Free;
  std::size_t FreeCount = 0;
  std::size_t Used = 0;
  std::size_t Whole = 0;
};
} // namespace palpate
