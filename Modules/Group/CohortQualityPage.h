#pragma once

#include "CohortQuality.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
/// The sections of a page: charts of compactness, generalisation and specificity, and a table of
/// the most unusual cases with a map each.
PALPATEGROUP_EXPORT std::string
CohortQualitySections(const CohortGroup& group, const CohortQuality& quality, bool showsNames);
} // namespace palpate
