#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// The report's charts as HTML: power of the model by degree, error of the fit against the degree,
/// and how the distances from model to surface are spread over the model's area. Each is left out
/// where its numbers are missing; empty where all are.
PALPATEFIT_EXPORT std::string ReportCharts(const FitResult& result);
} // namespace palpate
