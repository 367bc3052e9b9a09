#pragma once

#include "PalpateIOModule.h"
#include "Volume.h"

namespace palpate
{
/// Reads a file of ImageFormats, or a DICOM series given by its folder or by one of its files.
/// Throws InputError.
PALPATEIO_EXPORT Volume ReadVolume(const std::filesystem::path& path,
                                   const VolumeChoice& choice = {});
} // namespace palpate
