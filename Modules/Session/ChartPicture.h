#pragma once

#include "ChartMark.h"
#include "PalpateSessionModule.h"
#include "Picture.h"

#include <vector>

namespace palpate
{
/// Draws marks on white, without a graphics system. `width` and `height` in the marks' units, each
/// of which takes `scale` pixels.
PALPATESESSION_EXPORT Picture DrawChart(const std::vector<ChartMark>& marks, double width,
                                        double height, double scale);
} // namespace palpate
