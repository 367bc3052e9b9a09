#pragma once

#include "LeftHandedAxes.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

namespace palpate
{
/// Reads a label map (NIfTI, NRRD, MetaImage), 3D Slicer's .seg.nrrd, or a DICOM segmentation
/// object. A file of names next to a label map (such as MRIcron's `aal.nii.txt` next to
/// `aal.nii.gz`) is used. Throws InputError, also if no voxel is labelled.
PALPATEIO_EXPORT Segmentation ReadSegmentation(const std::filesystem::path& path,
                                               LeftHandedAxes leftHanded = LeftHandedAxes::Reverse);
} // namespace palpate
