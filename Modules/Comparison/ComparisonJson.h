#pragma once

#include "PairComparison.h"
#include "PalpateComparisonModule.h"

#include <string>

namespace palpate
{
/// A pair as a JSON object on one line. `folder` holds its files; empty if none. Values that do not
/// exist, such as the volume of an open surface, are null.
PALPATECOMPARISON_EXPORT std::string ComparisonJson(const PairComparison& pair,
                                                    const std::string& folder);
} // namespace palpate
