#pragma once

#include <array>
#include <cstddef>

namespace palpate
{
/// Values at the corners of a cell, i fastest.
using CellCorners = std::array<double, 8>;

/// The part (0 to 1) of a cell where `count` trilinear values between their corners, one or two,
/// are not negative: exact along k, by Gauss' rule of four points along i and j. Off by a hundredth
/// where a surface bends in the cell, without preference for more or less, so that sums over many
/// cells are better than each.
double InsidePartOfCell(const CellCorners* values, std::size_t count) noexcept;
inline double InsidePartOfCell(const CellCorners& corners) noexcept
{
  return InsidePartOfCell(&corners, 1);
}
} // namespace palpate
