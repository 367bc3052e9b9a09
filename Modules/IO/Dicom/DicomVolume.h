#pragma once

#include "DicomSeries.h"
#include "PalpateIOModule.h"
#include "Volume.h"

#include <filesystem>

namespace palpate
{
/// Reads the pixels of a series (after each slice's rescale slope) into one image, slices ordered
/// along their normal. `source` is the path given by the user. Throws InputError for uneven or
/// sheared stacks, missing or duplicate slices, colours and damaged files.
PALPATEIO_EXPORT Volume ReadDicomVolume(const DicomSeries& series,
                                        const std::filesystem::path& source);
} // namespace palpate
