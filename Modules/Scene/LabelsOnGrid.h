#pragma once

#include "PalpateSceneModule.h"

#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// A label map on another image's grid: at each of its nodes the label of the nearest voxel, in
/// millimetres, and 0 outside the map. The map itself where it lies on that grid already.
PALPATESCENE_EXPORT vtkSmartPointer<vtkImageData> LabelsOnGrid(vtkImageData* labels,
                                                               vtkImageData* image);
} // namespace palpate
