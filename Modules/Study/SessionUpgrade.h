#pragma once

#include "PalpateStudyModule.h"

#include <nlohmann/json.hpp>

namespace palpate
{
/// Turns a session of version 1 (0.1.0), whose scene stood beside its views under names of its own,
/// into one of the present version. Leaves everything else as it is, whatever it is.
PALPATESTUDY_EXPORT void UpgradeSession(nlohmann::json& root);
} // namespace palpate
