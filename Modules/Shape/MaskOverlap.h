#pragma once

#include "PalpateShapeModule.h"

class vtkImageData;
class vtkPolyData;

namespace palpate
{
/// Dice coefficient (0..1) of a closed surface (world mm) and the voxels of a label map that have
/// `label`: twice the voxels in both over the sum of the voxels in each. A voxel belongs to the
/// surface if its centre lies inside. The label map's direction is honoured; its grid is continued
/// beyond its border with empty voxels. For a surface that extends further beyond the border than
/// the label map is wide, voxels are counted by its volume, so that memory is bounded by the label
/// map's size. 0 for a surface with a non-finite point.
PALPATESHAPE_EXPORT double DiceOfSurfaceAndMask(vtkPolyData* surface, vtkImageData* mask,
                                                int label);
} // namespace palpate
