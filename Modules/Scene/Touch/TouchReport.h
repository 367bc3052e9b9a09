#pragma once

#include "PalpateSceneModule.h"
#include "TouchRun.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Numerical summary of a touch as one JSON object.
PALPATESCENE_EXPORT std::string TouchSummaryText(const PreparedTouch& touch,
                                                 const TouchResult& result);

/// What was drilled as text, one line per structure.
PALPATESCENE_EXPORT std::vector<std::string> DrillLines(const PreparedTouch& touch,
                                                        const TouchResult& result);

/// Writes into an existing folder: `summary.json`, `scene.json` and `report.html` with force, depth
/// and tick time over time. Throws InputError.
PALPATESCENE_EXPORT void WriteTouchFiles(const std::filesystem::path& folder,
                                         const PreparedTouch& touch, const TouchResult& result);
} // namespace palpate
