#pragma once

#include "CohortQuality.h"
#include "PalpateGroupModule.h"

namespace palpate
{
class ReportPage;

/// Adds charts of compactness, generalisation and specificity, and a table of the most unusual
/// cases with a map each.
PALPATEGROUP_EXPORT void AddCohortQuality(ReportPage& page, const CohortGroup& group,
                                          const CohortQuality& quality, bool showsNames);
} // namespace palpate
