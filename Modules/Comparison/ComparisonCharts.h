#pragma once

#include "ComparisonMap.h"
#include "PairComparison.h"
#include "PalpateComparisonModule.h"

namespace palpate
{
class ReportPage;

/// Adds charts of a pair: how much of the first surface is at each distance from the reference, and
/// the surface Dice at each tolerance.
PALPATECOMPARISON_EXPORT void AddComparisonCharts(ReportPage& page, const PairComparison& pair);

/// Adds an axial, a sagittal and a coronal plane through the middle of both surfaces with their
/// outlines.
PALPATECOMPARISON_EXPORT void AddComparisonSlices(ReportPage& page, const PairComparison& pair,
                                                  const ComparisonMap& map);
} // namespace palpate
