#pragma once

#include "ComplianceMaps.h"

#include <nlohmann/json.hpp>

#include <string>

namespace palpate
{
/// The entry "elasticity" of a model file. Throws InputError for maps that are not complete.
nlohmann::ordered_json ComplianceAsJson(const ComplianceMaps& maps, const std::string& fileName);

/// Throws InputError if an entry is missing or is not what it has to be, and for maps that are not
/// those of a body.
ComplianceMaps ComplianceFromJson(const nlohmann::ordered_json& entry, const std::string& fileName);
} // namespace palpate
