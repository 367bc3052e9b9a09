#pragma once

#include <array>

namespace palpate
{
/// The part (0 to 1) of a cell where the trilinear value between its corners (i fastest) is not
/// negative: exact along k, by Gauss' rule of four points along i and j. Off by a hundredth where a
/// surface bends in the cell, without preference for more or less, so that sums over many cells are
/// better than each.
double InsidePartOfCell(const std::array<double, 8>& corners) noexcept;
} // namespace palpate
