#pragma once

#include "DicomSource.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Writes a DICOM segmentation object, BINARY, under AtomicFile's rules: a segment for each
/// structure, numbered from 1, and a frame for each plane (FramePlanes) in which it has a voxel.
/// Frames on the series' slices reference these; others the whole series. A structure without codes
/// gets those of its name (OrganCodes). Returns whether the voxels are those of the series. Throws
/// InputError, also for more than 4 GB of pixels.
/// Source: DICOM PS3.3, A.51 and C.8.20.
PALPATEIO_EXPORT bool WriteDicomSegmentation(const std::filesystem::path& path,
                                             const Segmentation& segmentation,
                                             const DicomSource& source);
} // namespace palpate
