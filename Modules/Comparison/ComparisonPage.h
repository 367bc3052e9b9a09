#pragma once

#include "ComparisonMap.h"
#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// "Dice 0.91; 95 % of both surfaces lie within 2.1 mm of the other one; ...": a pair in a sentence
/// or two, plain text.
PALPATECOMPARISON_EXPORT std::string ComparisonVerdict(const PairComparison& pair);

/// A whole page on a compared pair: sentence, numbers, outlines, maps from six sides, charts, bias
/// by side and definitions. Files are named without their folders.
PALPATECOMPARISON_EXPORT std::string ComparisonPage(const PairComparison& pair,
                                                    const ComparisonMap& map);
} // namespace palpate
