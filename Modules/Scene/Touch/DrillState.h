#pragma once

#include "DrillRecords.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Writes the drilled state to a file: a record of each structure. Ends the current stroke. Throws
/// InputError if it cannot be written.
PALPATESCENE_EXPORT void WriteDrillState(const std::filesystem::path& path,
                                         const DrillContext& context);

/// Restores a saved state, before anything is drilled. Throws InputError if the file is malformed,
/// damaged, or belongs to other structures.
PALPATESCENE_EXPORT void ReadDrillState(const std::filesystem::path& path,
                                        const DrillContext& context);
/// The same for records that were read from `path`: one for each structure, in their order.
PALPATESCENE_EXPORT void RestoreDrillState(const std::vector<DrillRecord>& records,
                                           const std::filesystem::path& path,
                                           const DrillContext& context);
} // namespace palpate
