#pragma once

#include "PalpateImagingModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The surface itself where its points have normals; otherwise one with the same points and
/// triangles that has them.
PALPATEIMAGING_EXPORT vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface);
} // namespace palpate
