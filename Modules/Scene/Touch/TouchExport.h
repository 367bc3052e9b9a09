#pragma once

#include "PalpateSceneModule.h"

#include <filesystem>

namespace palpate
{
struct TouchRecording;

/// Writes a recorded touch as what the file's ending says: every tick as a line of CSV, or plots as
/// SVG. Throws InputError.
PALPATESCENE_EXPORT void ExportTouch(const TouchRecording& recording,
                                     const std::filesystem::path& file);
/// The same of one in a file. Answers whether it was cut off.
PALPATESCENE_EXPORT bool ExportTouch(const std::filesystem::path& recording,
                                     const std::filesystem::path& file);
} // namespace palpate
