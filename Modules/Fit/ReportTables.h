#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

namespace palpate
{
class ReportPage;

/// Adds every number of a result; stages that were not reached are omitted.
PALPATEFIT_EXPORT void ReportNumbers(ReportPage& page, const FitResult& result);
} // namespace palpate
