#pragma once

#include "FitSettings.h"
#include "PalpateSessionModule.h"

#include <nlohmann/json.hpp>

namespace palpate
{
/// The entry "fit" of sessions; the words are those of the command line. `file` is for messages.
/// Throws InputError.
PALPATESESSION_EXPORT FitSettings ReadFitSettings(const nlohmann::json& object,
                                                  const std::filesystem::path& file);
PALPATESESSION_EXPORT nlohmann::ordered_json FitSettingsJson(const FitSettings& settings);
} // namespace palpate
