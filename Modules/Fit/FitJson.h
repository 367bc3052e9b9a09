#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <string>

namespace palpate
{
/// One result as a JSON object on one line. `folder` holds its files; empty if none. Values of
/// stages that were not reached are null.
PALPATEFIT_EXPORT std::string FitResultJson(const FitResult& result, const std::string& folder);
} // namespace palpate
