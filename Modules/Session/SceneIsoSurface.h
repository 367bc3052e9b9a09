#pragma once

#include "PalpateSessionModule.h"
#include "Progress.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// Where an image passes a value, as triangles, for what is drawn and not felt. Linear between
/// voxels; points in world mm (patient LPS); triangles run counter-clockwise seen from where the
/// image is less; open where the image ends. Throws FilterError where the image does not pass the
/// value, and Cancelled.
PALPATESESSION_EXPORT vtkSmartPointer<vtkPolyData>
MakeIsoSurface(vtkImageData* image, double isoValue, const ProgressFunction& progress);
} // namespace palpate
