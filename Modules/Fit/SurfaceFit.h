#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"
#include "Progress.h"

namespace palpate
{
/// Maps the structure of `result`, or the component of this number (0: all of it), to the parameter
/// sphere and stores it in its details; replaces its surface. Returns why the structure cannot be
/// mapped, as a predicate, or an empty text. Throws Cancelled.
PALPATEFIT_EXPORT std::string MapToParameterSphere(FitResult& result, int component,
                                                   const ProgressFunction& progress);

/// Notes what was changed to map a mask.
PALPATEFIT_EXPORT void RemarkOnRepair(FitResult& result);

/// Fits a surface model to the mapped structure of `result` and draws it. Returns why it cannot, or
/// an empty text. Throws Cancelled.
PALPATEFIT_EXPORT std::string FitSurfaceModel(FitResult& result, const ProgressFunction& progress);
} // namespace palpate
