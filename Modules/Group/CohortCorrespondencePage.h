#pragma once

#include "CohortCorrespondence.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
/// A section of the cohort's page (HTML): each case as an image at one scale with the colours of
/// ParameterColor, the farthest from the others first, flipped cases and outliers marked; empty
/// without cases.
PALPATEGROUP_EXPORT std::string
CohortCorrespondenceSection(const CohortGroup& group, const CohortCorrespondence& correspondence,
                            bool showsNames);
} // namespace palpate
