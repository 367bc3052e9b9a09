#pragma once

#include "PalpateStudyModule.h"

#include <nlohmann/json.hpp>

namespace palpate
{
/// Converts a session of version 1 (0.1.0), whose scene entries stood next to its views under other
/// names and which had distances instead of measurements, to the present version. Leaves anything
/// else unchanged.
PALPATESTUDY_EXPORT void UpgradeSession(nlohmann::json& root);
} // namespace palpate
