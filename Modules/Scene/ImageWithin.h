#pragma once

#include "PalpateSceneModule.h"
#include "Vector3.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The part of an image (one component, patient LPS) round a box in the world (mm), as a copy: all
/// nodes that values in the box are interpolated from, with the same scalars in the same places.
/// The image itself where the box is outside it.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> ImageWithin(vtkImageData* image,
                                                              const Eigen::AlignedBox3d& boxWorld);
} // namespace palpate
