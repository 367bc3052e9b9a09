#pragma once

#include "PalpateSceneModule.h"
#include "Vector3.h"
#include "vtkImageData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// Copies the part of an image (one component, patient LPS) around a box in the world (mm): all
/// nodes needed to interpolate within the box, with unchanged scalars and positions. Returns the
/// image itself if the box lies outside of it.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> ImageWithin(vtkImageData* image,
                                                              const Eigen::AlignedBox3d& boxWorld);
} // namespace palpate
