#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// Why the fitted model of a result cannot describe its structure, regardless of its overlap: a
/// predicate with numbers ("is not described by ..."); empty for a plausible model. Needs Model,
/// ModelMilliliters, ModelSurface and Surface. A model is implausible if it encloses no positive,
/// finite volume, or if its radius leaves the range from -1 to 2 times the distance of the
/// structure's farthest point. Samples that leave part of the sphere uncovered cause such models.
PALPATEFIT_EXPORT std::string WhyImplausible(const FitResult& result);

/// A remark on a plausible model whose radius is negative somewhere; otherwise empty.
PALPATEFIT_EXPORT std::string RemarkOnNegativeRadius(const FitResult& result);
} // namespace palpate
