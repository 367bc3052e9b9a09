#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Whether the name is that of a 3D Slicer segmentation, .seg.nrrd.
PALPATEIO_EXPORT bool IsSlicerSegmentation(const std::filesystem::path& path);

/// Writes a 3D Slicer segmentation, compressed, under AtomicFile's rules: the layers as they are
/// (all of one grid), with the value, name, colour and extent of every segment; a segment without a
/// name is named by its label. Patient LPS, mm. Throws InputError. Source: Slicer's documentation
/// of the format, and slicerio's reader.
PALPATEIO_EXPORT void WriteSegmentation(const std::filesystem::path& path,
                                        const Segmentation& segmentation);
} // namespace palpate
