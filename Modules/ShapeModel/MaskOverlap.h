#pragma once

#include "PalpateShapeModelModule.h"

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// Dice coefficient (0..1) of a closed surface (world mm) and the voxels of a label map that have
/// `label`: twice the voxels in both over the sum of the voxels in each. A voxel belongs to the
/// surface if its centre lies inside. The label map's direction is honoured; beyond its border its
/// grid is thought to go on, with empty voxels.
PALPATESHAPEMODEL_EXPORT double DiceOfSurfaceAndMask(vtkPolyData* surface, vtkImageData* mask,
                                                     int label);
} // namespace palpate
