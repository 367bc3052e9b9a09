#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"

#include <string>

namespace palpate
{
/// The most modes on a page.
constexpr int MostShownModes = 5;

/// Number of modes with images: at most five.
PALPATEGROUP_EXPORT int ShownModes(const CohortGroup& group);

/// One self-contained HTML page: the mean shape, the principal modes as the mean plus and minus
/// `deviations` standard deviations, all at the same scale and coloured by their distance outside
/// or inside the mean (mm), the variance explained by the modes, a table of cases, notes, and the
/// methods (CohortMethods).
PALPATEGROUP_EXPORT std::string CohortPage(const CohortGroup& group, const CohortOutput& output,
                                           double deviations, const std::string& program);
} // namespace palpate
