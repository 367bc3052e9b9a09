#pragma once

#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// True for a DICOM file whose SOP class is Segmentation Storage or Label Map Segmentation Storage.
/// Throws InputError if it is not a DICOM file.
PALPATEIO_EXPORT bool IsDicomSegmentation(const std::filesystem::path& file);

/// Reads a DICOM segmentation object: BINARY (segments may overlap), LABELMAP, and FRACTIONAL,
/// which is thresholded at half of its maximum, with a note. Labels are the segment numbers; frames
/// may be unordered and slices without a frame are empty. Colours are converted from CIELab (D50)
/// to sRGB. Throws InputError. Source: DICOM PS3.3 A.51, C.8.20.
PALPATEIO_EXPORT Segmentation ReadDicomSegmentation(const std::filesystem::path& file);
} // namespace palpate
