#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"

#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// Every setting of a fit as name and value, for reports and for the provenance of files. The
/// names and values are those of the command line's options.
PALPATEFIT_EXPORT std::vector<std::pair<std::string, std::string>>
DescribeSettings(const FitSettings& settings);
} // namespace palpate
