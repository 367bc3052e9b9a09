#pragma once

#include "DicomSeries.h"
#include "PalpateIOModule.h"
#include "Volume.h"

#include <filesystem>

namespace palpate
{
/// Reads the pixels of a series (after each slice's rescale slope) into one image, slices ordered
/// along their normal. `source` is what the user named. Throws InputError: uneven or sheared
/// stacks, slices that are missing or twice there, colours, damaged files.
PALPATEIO_EXPORT Volume ReadDicomVolume(const DicomSeries& series,
                                        const std::filesystem::path& source);
} // namespace palpate
