#pragma once

#include "DicomSource.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

#include <filesystem>

namespace palpate
{
/// Writes a DICOM structure set under AtomicFile's rules: the outlines of each structure
/// (MaskOutlines) as closed contours in the series' slices, which they reference. Of voxels that
/// are not those of the series, the nearest ones are taken. Returns whether they are. Throws
/// InputError, also for a structure without a contour, or with several thousand in a slice. Source:
/// DICOM PS3.3, A.19 and C.8.8.5 to C.8.8.8.
PALPATEIO_EXPORT bool WriteDicomStructureSet(const std::filesystem::path& path,
                                             const Segmentation& segmentation,
                                             const DicomSource& source);
} // namespace palpate
