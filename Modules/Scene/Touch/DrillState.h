#pragma once

#include "DrillContext.h"
#include "PalpateSceneModule.h"

#include <filesystem>

namespace palpate
{
/// Writes the drilled state to a file: for each structure its name, a digest of the voxels that it
/// was made from, and the removed region (RemovalBytes). Ends the current stroke. Throws InputError
/// if it cannot be written.
PALPATESCENE_EXPORT void WriteDrillState(const std::filesystem::path& path,
                                         const DrillContext& context);

/// Restores a saved state, before anything is drilled. Throws InputError if the file is malformed,
/// damaged, or belongs to other structures.
PALPATESCENE_EXPORT void ReadDrillState(const std::filesystem::path& path,
                                        const DrillContext& context);
} // namespace palpate
