#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Whether a DICOM file is a structure set (contours). Throws InputError if it cannot be parsed.
PALPATEIO_EXPORT bool IsDicomStructureSet(const std::filesystem::path& file);

/// Reads the closed contours of a structure set as a segmentation (see ContourFill); structures
/// that overlap are in several layers, and numbered by their order in the file. Voxels are those of
/// the images that the contours were drawn on, as far as the contours extend, if their series is
/// next to the file; otherwise a grid is made from the contours (GridOfContours). A note says
/// which. Layers take at most 8 MiB, 1,024 bytes for each byte of the contours, or 8 for each byte
/// of the images. Throws InputError.
PALPATEIO_EXPORT Segmentation ReadDicomStructureSet(const std::filesystem::path& file);
} // namespace palpate
