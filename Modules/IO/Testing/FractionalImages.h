#pragma once

#include "Vector3.h"

#include <filesystem>

namespace palpate::test
{
/// Position of the first voxel of a.nii, a.seg.nrrd, a.mha and dicom, and voxel size (mm); DICOM's
/// is 2 and 1.5 within the slice.
inline Vector3 FractionalOrigin()
{
  return {10.125, -20.5, 30.75};
}
inline Vector3 FractionalSpacing()
{
  return {1.5, 0.75, 3.25};
}

/// Writes an image of each format into a folder, with numbers that are misread if a decimal point
/// ends a number: a.nii, a.seg.nrrd (with a colour), b.nrrd (spacings without an origin), a.mha, a
/// DICOM series in the folder dicom, and the DICOM segmentation seg.dcm.
void WriteFractionalImages(const std::filesystem::path& folder);
} // namespace palpate::test
