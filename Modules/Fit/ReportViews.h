#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

namespace palpate
{
class ReportPage;

/// Adds the structure from six sides: the model, coloured by its signed distance (mm) to the
/// surface that it was fitted to, with a colour bar; the surface in one colour if there is no
/// model; nothing if there is neither. Drawn on the CPU.
PALPATEFIT_EXPORT void ReportViews(ReportPage& page, const FitResult& result);
} // namespace palpate
