#pragma once

#include "FitSettings.h"
#include "JsonFields.h"
#include "PalpateFitModule.h"

#include <nlohmann/json.hpp>

namespace palpate
{
/// The entry "fit" of scenes and sessions; the values are those of the command line.
PALPATEFIT_EXPORT void ExchangeFitSettings(JsonFields& fields, FitSettings& settings);
PALPATEFIT_EXPORT nlohmann::ordered_json FitSettingsJson(FitSettings settings);
} // namespace palpate
