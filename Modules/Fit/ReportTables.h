#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// Every number of a result as HTML tables; stages that were not reached are omitted.
PALPATEFIT_EXPORT std::string ReportNumbers(const FitResult& result);

/// Every setting of a fit as an HTML table.
PALPATEFIT_EXPORT std::string ReportSettings(const FitSettings& settings);
} // namespace palpate
