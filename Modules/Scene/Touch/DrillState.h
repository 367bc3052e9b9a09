#pragma once

#include "DrillBench.h"
#include "PalpateSceneModule.h"

#include <filesystem>

namespace palpate
{
/// What was drilled so far, in a file: for each structure its name, a digest of the voxels that it
/// was made from, and what is removed (RemovalBytes). The stroke ends. Throws InputError where it
/// cannot be written.
PALPATESCENE_EXPORT void WriteDrillState(const std::filesystem::path& path,
                                         const DrillBench& bench);

/// Puts a bench into a state that was kept earlier, before anything is drilled. Throws InputError
/// for what is no such file, is damaged, or belongs to other structures.
PALPATESCENE_EXPORT void ReadDrillState(const std::filesystem::path& path, const DrillBench& bench);
} // namespace palpate
