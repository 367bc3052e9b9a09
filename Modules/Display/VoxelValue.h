#pragma once

#include "PalpateDisplayModule.h"
#include "Vector3.h"

#include <optional>

class vtkImageData;

namespace palpate
{
/// The value (first component) of the voxel at a point (world, mm); empty outside the image, which
/// extends half a voxel beyond the outermost centres.
PALPATEDISPLAY_EXPORT std::optional<double> VoxelValueAt(vtkImageData* image,
                                                         const Vector3& pointWorld);
} // namespace palpate
