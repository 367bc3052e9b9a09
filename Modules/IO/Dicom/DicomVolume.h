#pragma once

#include "DicomSeries.h"
#include "PalpateIOModule.h"
#include "Volume.h"

#include <filesystem>

namespace palpate
{
/// Reads the pixels of a series (after each slice's rescale slope) into one image, slices ordered
/// along their normal; slices that are there twice with equal pixels count once. `source` is the
/// path given by the user. Throws InputError for uneven stacks, missing slices, two images at one
/// position, colours and damaged files, and for sheared stacks unless `sheared` keeps them for
/// ResampleSheared.
PALPATEIO_EXPORT Volume ReadDicomVolume(const DicomSeries& series,
                                        const std::filesystem::path& source,
                                        ShearedAxes sheared = ShearedAxes::Refuse);
} // namespace palpate
