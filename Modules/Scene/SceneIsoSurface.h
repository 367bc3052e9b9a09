#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// The closed surface of the region where an image is at least `isoValue`: triangles in world mm
/// (patient LPS), counter-clockwise seen from the side of lower values, linear between voxels. A
/// region that reaches the border of the image is closed there, as in a field. Throws FilterError
/// if no voxel reaches the value, and Cancelled.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData>
MakeIsoSurface(vtkImageData* image, double isoValue, const ProgressFunction& progress);
} // namespace palpate
