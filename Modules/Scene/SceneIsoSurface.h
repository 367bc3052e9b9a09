#pragma once

#include "PalpateSceneModule.h"
#include "Progress.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// The closed surface of what of an image is at least `isoValue`: triangles in world mm (patient
/// LPS), counter-clockwise seen from where the image is less; linear between voxels. Where that
/// goes on beyond the image it is closed at the border, as a field is. Throws FilterError where
/// nothing reaches the value, and Cancelled.
PALPATESCENE_EXPORT vtkSmartPointer<vtkPolyData>
MakeIsoSurface(vtkImageData* image, double isoValue, const ProgressFunction& progress);
} // namespace palpate
