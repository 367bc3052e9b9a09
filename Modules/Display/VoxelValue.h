#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <optional>

class vtkImageData;

namespace palpate
{
/// The value (first component) of the voxel that a point (world, mm) lies in; none outside of the
/// image. Up to half a voxel beyond the outermost centres belongs to the image.
PALPATEDISPLAY_EXPORT std::optional<double> VoxelValueAt(vtkImageData* image,
                                                         const Vector3& pointWorld);
} // namespace palpate
