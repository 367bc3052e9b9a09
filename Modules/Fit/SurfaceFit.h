#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "Progress.h"

namespace palpate
{
/// Maps the structure of `result` to the parameter sphere and stores it in its details, with
/// remarks on what was changed; replaces its surface. Returns why the structure cannot be mapped,
/// as a predicate, or an empty text. Throws Cancelled.
PALPATEFIT_EXPORT std::string MapToParameterSphere(FitResult& result,
                                                   const ProgressFunction& progress);

/// Fits a surface model to the mapped structure of `result` and draws it. Returns why it cannot, or
/// an empty text. Throws Cancelled.
PALPATEFIT_EXPORT std::string FitSurfaceModel(FitResult& result, const ProgressFunction& progress);
} // namespace palpate
