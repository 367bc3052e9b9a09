#pragma once

#include "PalpateSceneModule.h"
#include "SvgChart.h"
#include "TouchTrace.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
using TouchQuantity = LeastAndMost TouchStretch::*;

/// Chart of a quantity over time: minimum and maximum of each interval, so that single-tick peaks
/// are visible.
PALPATESCENE_EXPORT SvgChart TouchChart(const TouchTrace& trace, TouchQuantity quantity,
                                        const std::string& label, bool isLogarithmic);

/// Whether the ending is that of plots: .svg.
PALPATESCENE_EXPORT bool IsTouchPlots(const std::filesystem::path& file);

/// Writes force, depth and period of recorded ticks over time as SVG, one chart below the other.
/// Throws InputError.
PALPATESCENE_EXPORT void WriteTouchPlots(const std::vector<TouchState>& ticks,
                                         const std::filesystem::path& file);
} // namespace palpate
