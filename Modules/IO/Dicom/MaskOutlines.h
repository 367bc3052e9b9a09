#pragma once

#include "PalpateIOModule.h"

#include <Eigen/Core>
#include <cstddef>
#include <optional>
#include <vector>

namespace palpate
{
/// A closed polygon in pixels: column, row; pixel centres are whole numbers.
using PixelOutline = std::vector<Eigen::Vector2d>;

/// Polygons around the pixels of one value, halfway between pixel centres, so that a pixel's centre
/// is inside of one if and only if it has the value. Pixels that touch at a corner are in polygons
/// of their own. A hole is joined to the polygon around it by a channel of no width (PS3.3,
/// C.8.8.6.3). `values` are rows of `columns` pixels. None if there would be more than `most`
/// outlines and holes.
PALPATEIO_EXPORT std::optional<std::vector<PixelOutline>>
MaskOutlines(const std::vector<int>& values, int columns, int value, std::size_t most);
} // namespace palpate
