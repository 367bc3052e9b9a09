#pragma once

#include "PalpateSceneModule.h"

#include <filesystem>

namespace palpate
{
struct TouchRecording;

/// Writes a recorded touch in the format given by the file's ending: CSV with one line per tick, or
/// SVG plots. Throws InputError.
PALPATESCENE_EXPORT void ExportTouch(const TouchRecording& recording,
                                     const std::filesystem::path& file);
/// The same for a recording in a file. Returns whether the recording is truncated.
PALPATESCENE_EXPORT bool ExportTouch(const std::filesystem::path& recording,
                                     const std::filesystem::path& file);
} // namespace palpate
