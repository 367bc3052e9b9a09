#pragma once

#include "PalpateDisplayModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The surface itself if its points have normals; otherwise a copy with the same points and
/// triangles and with normals.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface);
} // namespace palpate
