#pragma once

#include "PalpateSceneModule.h"
#include "TouchState.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// Whether the ending is that of a recorded touch: .touch, or .part where it was not finished.
PALPATESCENE_EXPORT bool IsTouchRecording(const std::filesystem::path& path);

/// Writes every tick of a recorded touch as a line of CSV; the first line names the columns with
/// their units. Lengths in the device's frame or, where a name says so, in the world. Throws
/// InputError.
PALPATESCENE_EXPORT void WriteTouchTicks(const std::vector<TouchState>& ticks,
                                         const std::filesystem::path& csv);
} // namespace palpate
