#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// The structure from six sides as HTML: the model, coloured by its signed distance (mm) to the
/// surface that it was fitted to, with a colour bar; the surface in one colour if there is no
/// model; empty if there is neither. Drawn on the CPU.
PALPATEFIT_EXPORT std::string ReportViews(const FitResult& result);
} // namespace palpate
