#pragma once

#include "PalpateIOModule.h"

#include <array>

namespace palpate
{
/// Red, green, blue (0..1) for a structure whose file gives none: label 1 has Segment's default,
/// the others follow round the colour circle in steps of the golden angle, so that neighbours
/// differ.
PALPATEIO_EXPORT std::array<double, 3> DefaultSegmentColor(int label);
} // namespace palpate
