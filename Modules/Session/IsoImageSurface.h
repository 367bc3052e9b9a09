#pragma once

#include "PalpateSessionModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

class vtkImageData;

namespace palpate
{
/// The closed surface of what of an image is at least `isoValue`, as triangles in patient LPS (mm),
/// outward. Where that goes on beyond the image it is closed at the border, as a field is. Throws
/// FilterError where nothing is.
PALPATESESSION_EXPORT vtkSmartPointer<vtkPolyData> MakeIsoImageSurface(vtkImageData* image,
                                                                       double isoValue);
} // namespace palpate
