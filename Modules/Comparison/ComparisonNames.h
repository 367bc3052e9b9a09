#pragma once

#include "BodyOverlap.h"
#include "PalpateComparisonModule.h"

#include <cstddef>
#include <string>

namespace palpate
{
/// "2", "0.5": a tolerance (mm) in names of columns and on pages.
PALPATECOMPARISON_EXPORT std::string ToleranceText(double millimeters);

/// "+1.20", "-0.30": a number with its sign.
PALPATECOMPARISON_EXPORT std::string SignedText(double value, int digits);

/// "left-posterior-superior": an octant of SideBias.
PALPATECOMPARISON_EXPORT std::string OctantName(std::size_t octant);

/// How an overlap was counted: "voxels of 0.5 x 0.5 x 3 mm".
PALPATECOMPARISON_EXPORT std::string CellsText(const BodyOverlap& overlap);
} // namespace palpate
