#pragma once

#include "PalpateIOModule.h"

#include <array>

namespace palpate
{
/// Default colour (red, green, blue, 0..1) of a structure: label 1 has Segment's default, the
/// others follow on the colour circle in steps of the golden angle, so that consecutive labels
/// differ.
PALPATEIO_EXPORT std::array<double, 3> DefaultSegmentColor(int label);
} // namespace palpate
