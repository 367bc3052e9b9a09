#pragma once

#include "PalpateSceneModule.h"
#include "TouchRun.h"

#include <nlohmann/json.hpp>
#include <string>

namespace palpate
{
/// What was drilled, as an entry of a touch's summary: "removed" (name, mm3), "orders", "forbidden"
/// (name, least distance and when, seconds within the alarm), "problem".
PALPATESCENE_EXPORT nlohmann::ordered_json DrillSummary(const PreparedTouch& touch,
                                                        const TouchResult& result);

/// The same for a reader: a line for each structure.
PALPATESCENE_EXPORT std::vector<std::string> DrillLines(const PreparedTouch& touch,
                                                        const TouchResult& result);

/// The same as a section of the report, with what was gone over time.
PALPATESCENE_EXPORT std::string DrillSection(const PreparedTouch& touch, const TouchResult& result);
} // namespace palpate
