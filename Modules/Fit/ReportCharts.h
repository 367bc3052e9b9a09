#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

namespace palpate
{
class ReportPage;

/// Adds the report's charts: power of the model by degree, error of the fit against the degree, and
/// distribution of the distances from model to surface over the model's area. Charts without
/// numbers are omitted.
PALPATEFIT_EXPORT void ReportCharts(ReportPage& page, const FitResult& result);
} // namespace palpate
