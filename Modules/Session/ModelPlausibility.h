#pragma once

#include "FitResult.h"
#include "PalpateSessionModule.h"

#include <string>

namespace palpate
{
/// Why the fitted model of a result cannot describe its structure, whatever its overlap: as a
/// predicate with numbers ("is not described by ..."); empty for a model that can. Needs Model,
/// ModelMilliliters, ModelSurface and Surface. A model is implausible if it encloses no positive,
/// finite volume, or reaches more than twice as far from its centre as the structure does anywhere.
/// Samples that leave part of the sphere free, or a centre outside, lead to such models.
PALPATESESSION_EXPORT std::string WhyImplausible(const FitResult& result);
} // namespace palpate
