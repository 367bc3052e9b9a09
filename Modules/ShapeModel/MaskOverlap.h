#pragma once

#include "PalpateShapeModelModule.h"

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// Dice coefficient (0..1) of a closed surface (world mm) and the voxels of a label map that have
/// `label`: twice the voxels in both over the sum of the voxels in each. A voxel belongs to the
/// surface if its centre lies inside. The label map's direction is honoured; beyond its border its
/// grid goes on, with empty voxels. Of a surface that reaches farther beyond than the label map is
/// wide, the voxels are counted by its volume, so that memory is bounded by the label map's size.
/// 0 for a surface with a point that is not finite.
PALPATESHAPEMODEL_EXPORT double DiceOfSurfaceAndMask(vtkPolyData* surface, vtkImageData* mask,
                                                     int label);
} // namespace palpate
