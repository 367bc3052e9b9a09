#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Whether the ending is that of a recorded touch: .touch, or .part for an unfinished one.
PALPATESCENE_EXPORT bool IsTouchRecording(const std::filesystem::path& path);

/// Writes a recorded touch as CSV, one line per tick; the first line names the columns with their
/// units. Lengths are in the device's frame or, if the name says so, in the world. Throws
/// InputError.
PALPATESCENE_EXPORT void WriteTouchTicks(const std::vector<TouchState>& ticks,
                                         const std::filesystem::path& csv);
} // namespace palpate
