#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"

#include <filesystem>

namespace palpate
{
struct TouchRecording;

/// Whether the ending is that of a recorded touch: .touch, or .part for an unfinished one.
PALPATESCENE_EXPORT bool IsTouchRecording(const std::filesystem::path& path);

/// Writes a recorded touch as CSV, one line per tick; the first line names the columns with their
/// units. Lengths are in the device's frame or, if the name says so, in the world. Throws
/// InputError, also for another ending, and Cancelled.
PALPATESCENE_EXPORT void ExportTouch(const TouchRecording& recording,
                                     const std::filesystem::path& file,
                                     const ProgressFunction& progress = {});
/// The same for a recording in a file. Returns whether the recording is truncated.
PALPATESCENE_EXPORT bool ExportTouch(const std::filesystem::path& recording,
                                     const std::filesystem::path& file,
                                     const ProgressFunction& progress = {});
} // namespace palpate
