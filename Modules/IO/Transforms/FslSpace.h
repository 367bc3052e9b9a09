#pragma once

#include "ImageGrid.h"
#include "PalpateIOModule.h"

#include <Eigen/Geometry>

namespace palpate
{
/// The map from FSL's coordinates of an image to the patient (LPS, mm). FSL's coordinates are mm
/// along the index axes of the file from its first voxel; if these axes are right-handed, the first
/// is counted from its other end. `grid` is that of the file (ImageFile::Grid), before any axis is
/// reversed. Source: FLIRT's FAQ on the format of its matrices.
PALPATEIO_EXPORT Eigen::Affine3d FslSpaceOf(const ImageGrid& grid);
} // namespace palpate
