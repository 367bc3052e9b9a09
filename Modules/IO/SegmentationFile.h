#pragma once

#include "LeftHandedAxes.h"
#include "PalpateIOModule.h"
#include "Segmentation.h"

namespace palpate
{
/// Reads a label map (NIfTI, NRRD, MetaImage), 3D Slicer's .seg.nrrd, or a DICOM segmentation
/// object. A file of names beside a label map (such as mricron's `aal.nii.txt` beside `aal.nii.gz`)
/// is used. Throws InputError, also where no voxel is labelled.
PALPATEIO_EXPORT Segmentation ReadSegmentation(const std::filesystem::path& path,
                                               LeftHandedAxes leftHanded = LeftHandedAxes::Reverse);
} // namespace palpate
