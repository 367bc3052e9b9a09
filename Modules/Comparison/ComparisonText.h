#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <string>
#include <vector>

namespace palpate
{
/// A pair as a table of some lines.
PALPATECOMPARISON_EXPORT std::string ComparisonText(const PairComparison& pair);
/// A pair of many as one line.
PALPATECOMPARISON_EXPORT std::string ComparisonLine(const PairComparison& pair);
/// Mean, median and extremes over pairs; empty without any that was compared.
PALPATECOMPARISON_EXPORT std::string SummaryText(const std::vector<PairComparison>& pairs);
} // namespace palpate
