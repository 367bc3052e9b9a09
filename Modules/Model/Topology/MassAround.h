#pragma once

#include "ShapeField.h"

#include <vector>

namespace palpate
{
/// The part of each node's neighbourhood that is inside, 0 to 1: a Gaussian average of `inside` (a
/// byte for each node of the grid, 0 or 1) with a standard deviation of `width` grid spacings.
/// Where that is wide it is computed on coarser nodes. Noise of the boundary hardly changes it.
ShapeField MassAround(const ShapeGrid& grid, const std::vector<unsigned char>& inside,
                      double width);
} // namespace palpate
