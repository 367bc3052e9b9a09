#pragma once

#include "LeftHandedAxes.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"
#include "Volume.h"

namespace palpate
{
/// Reads a label map (a file of ImageFormats), 3D Slicer's .seg.nrrd, a DICOM segmentation
/// object or structure set. A file of names next to a label map (such as MRIcron's `aal.nii.txt`
/// next to `aal.nii.gz`) is used. Also a folder of masks, if they are structures
/// (MaskFolder). Throws InputError, also if no voxel is labelled.
PALPATEIO_EXPORT Segmentation ReadSegmentation(const std::filesystem::path& path,
                                               LeftHandedAxes leftHanded = LeftHandedAxes::Reverse);

/// The same; of a file of several volumes, the one that is chosen by its number.
PALPATEIO_EXPORT Segmentation ReadSegmentation(const std::filesystem::path& path,
                                               const VolumeChoice& choice);
} // namespace palpate
