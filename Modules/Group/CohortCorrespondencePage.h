#pragma once

#include "CohortCorrespondence.h"
#include "PalpateGroupModule.h"

#include <iosfwd>

namespace palpate
{
/// Writes a section of the cohort's page (HTML): each case as an image at one scale with the
/// colours of ParameterColor, the farthest from the others first, flipped cases and outliers
/// marked; nothing without cases. Its images are never all in memory.
PALPATEGROUP_EXPORT void
WriteCohortCorrespondenceSection(const CohortGroup& group,
                                 const CohortCorrespondence& correspondence, bool showsNames,
                                 std::ostream& page);
} // namespace palpate
