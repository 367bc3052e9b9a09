#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// The report's charts as HTML: power of the model by degree, error of the fit against the degree,
/// and distribution of the distances from model to surface over the model's area. Charts without
/// numbers are omitted; empty if all are.
PALPATEFIT_EXPORT std::string ReportCharts(const FitResult& result);
} // namespace palpate
