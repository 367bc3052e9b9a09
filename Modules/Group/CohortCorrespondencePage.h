#pragma once

#include "CohortCorrespondence.h"
#include "PalpateGroupModule.h"

namespace palpate
{
class ReportPage;

/// Adds each case as an image at one scale with the colours of ParameterColor, the farthest from
/// the others first, flipped cases and outliers marked; nothing without cases.
PALPATEGROUP_EXPORT void AddCohortCorrespondence(ReportPage& page, const CohortGroup& group,
                                                 const CohortCorrespondence& correspondence,
                                                 bool showsNames);
} // namespace palpate
