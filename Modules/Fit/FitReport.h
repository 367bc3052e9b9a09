#pragma once

#include "FitResult.h"
#include "PalpateFitModule.h"

#include <filesystem>

namespace palpate
{
/// Writes the result of one structure as one self-contained HTML file, without network or graphics
/// system: verdict, key numbers, slices with contours, the distances on the model from six sides,
/// charts, every number and setting, and versions. The report of a refused structure contains the
/// completed stages. Without a volume the slices show the mask. File names appear without folders.
/// Throws InputError if the file cannot be written.
PALPATEFIT_EXPORT void WriteFitReport(const FitResult& result, const Volume* volumeOrNull,
                                      const std::filesystem::path& html);
} // namespace palpate
