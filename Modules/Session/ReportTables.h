#pragma once

#include "FitResult.h"
#include "PalpateSessionModule.h"

#include <string>

namespace palpate
{
/// Every number of a result as HTML tables; those of stages that were not reached are left out.
PALPATESESSION_EXPORT std::string ReportNumbers(const FitResult& result);

/// Every setting of a fit as an HTML table.
PALPATESESSION_EXPORT std::string ReportSettings(const FitSettings& settings);
} // namespace palpate
