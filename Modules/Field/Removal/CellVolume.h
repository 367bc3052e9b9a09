#pragma once

#include <array>
#include <cstddef>

namespace palpate
{
/// Values at the corners of a cell, i fastest.
using CellCorners = std::array<double, 8>;

/// The fraction (0 to 1) of a cell where `count` (one or two) values, trilinear between their
/// corners, are not negative: exact along k, by Gauss' rule of four points along i and j. The error
/// is up to a hundredth if a surface bends in the cell, and unbiased, so that sums over many cells
/// are more accurate than each.
double InsidePartOfCell(const CellCorners* values, std::size_t count) noexcept;
inline double InsidePartOfCell(const CellCorners& corners) noexcept
{
  return InsidePartOfCell(&corners, 1);
}
} // namespace palpate
