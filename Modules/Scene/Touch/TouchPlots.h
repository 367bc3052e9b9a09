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

/// A quantity over time: the least and the most of each stretch, so that a peak of one tick is
/// seen.
PALPATESCENE_EXPORT SvgChart TouchChart(const TouchTrace& trace, TouchQuantity quantity,
                                        const std::string& label, bool isLogarithmic);

/// Whether plots can be written so: .svg.
PALPATESCENE_EXPORT bool IsTouchPlots(const std::filesystem::path& file);

/// Force, depth and period of recorded ticks over time, below each other, as SVG. Throws
/// InputError.
PALPATESCENE_EXPORT void WriteTouchPlots(const std::vector<TouchState>& ticks,
                                         const std::filesystem::path& file);
} // namespace palpate
