#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <filesystem>

namespace palpate
{
/// Writes what became of one structure as one HTML file that needs nothing else, no network and no
/// graphics system: verdict, key numbers, slices with contours, the distances on the model from six
/// sides, charts, every number and setting, and versions. Refused structures get a report of as far
/// as they came. Without a volume the slices show the mask. Of file names only the last part
/// appears. Throws InputError where the file cannot be written.
PALPATEFIT_EXPORT void WriteFitReport(const FitResult& result, const Volume* volumeOrNull,
                                      const std::filesystem::path& html);
} // namespace palpate
