#pragma once

#include "FitSettings.h"
#include "PalpateFitModule.h"

#include <nlohmann/json.hpp>

namespace palpate
{
/// The entry "fit" of session files; the values are those of the command line. `file` is for
/// messages. Throws InputError.
PALPATEFIT_EXPORT FitSettings ReadFitSettings(const nlohmann::json& object,
                                              const std::filesystem::path& file);
PALPATEFIT_EXPORT nlohmann::ordered_json FitSettingsJson(const FitSettings& settings);
} // namespace palpate
