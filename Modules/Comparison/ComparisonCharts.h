#pragma once

#include "ComparisonMap.h"
#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// Charts of a pair as HTML: how much of the first surface is at each distance from the reference,
/// and the surface Dice at each tolerance.
PALPATECOMPARISON_EXPORT std::string ComparisonCharts(const PairComparison& pair);

/// An axial, a sagittal and a coronal plane through the middle of both surfaces with their
/// outlines, as HTML.
PALPATECOMPARISON_EXPORT std::string ComparisonSlices(const PairComparison& pair,
                                                      const ComparisonMap& map);
} // namespace palpate
