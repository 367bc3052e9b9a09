#pragma once

#include "PalpateSceneModule.h"
#include "TouchRun.h"

#include <nlohmann/json.hpp>
#include <string>

namespace palpate
{
/// Summary of drilling as JSON: "removed" (name, mm3), "orders", "forbidden" (name, smallest
/// distance and its time, seconds within the alarm distance), "problem".
PALPATESCENE_EXPORT nlohmann::ordered_json DrillSummary(const PreparedTouch& touch,
                                                        const TouchResult& result);

/// The same as text: one line per structure.
PALPATESCENE_EXPORT std::vector<std::string> DrillLines(const PreparedTouch& touch,
                                                        const TouchResult& result);

/// The same as a section of the report, with charts of removed volume over time.
PALPATESCENE_EXPORT std::string DrillSection(const PreparedTouch& touch, const TouchResult& result);
} // namespace palpate
