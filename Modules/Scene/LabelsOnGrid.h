#pragma once

#include "PalpateSceneModule.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// Resamples a label map onto another image's grid: each node gets the label of the voxel nearest
/// in mm, or 0 outside of the map. Returns the map itself if it already lies on that grid.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> LabelsOnGrid(vtkImageData* labels,
                                                               vtkImageData* image);
} // namespace palpate
