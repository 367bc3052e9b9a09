#pragma once

#include "PalpateDisplayModule.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// The first component of an image, if necessary as averages of blocks of voxels with equal sides,
/// the smallest ones that leave at most `mostVoxels`; voxels that fill no block at the upper border
/// are left out. Its values are those of the image, its frame is the image's. Float if it is
/// averaged.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkImageData> ReducedImage(vtkImageData* image,
                                                                 double mostVoxels);
} // namespace palpate
