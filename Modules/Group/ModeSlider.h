#pragma once

#include "CohortGroup.h"
#include "PalpateGroupModule.h"
#include "ShapeFigures.h"

#include <string>

namespace palpate
{
/// A slider of a page (HTML with a line of script) over nine images of the mean plus -`deviations`
/// to `deviations` standard deviations of a mode; on paper, and without script, the mean.
PALPATEGROUP_EXPORT std::string ModeSlider(const CohortGroup& group, int mode, double deviations,
                                           const ShapeFigures& figures);
} // namespace palpate
