#pragma once

#include "PalpateSessionModule.h"

#include <filesystem>

namespace palpate
{
struct TouchRecording;

/// Writes a recorded touch as what the file's ending says: every tick as a line of CSV, or plots as
/// SVG. Throws InputError.
PALPATESESSION_EXPORT void ExportTouch(const TouchRecording& recording,
                                       const std::filesystem::path& file);
/// The same of one in a file. Answers whether it was cut off.
PALPATESESSION_EXPORT bool ExportTouch(const std::filesystem::path& recording,
                                       const std::filesystem::path& file);
} // namespace palpate
