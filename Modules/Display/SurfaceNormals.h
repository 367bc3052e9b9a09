#pragma once

#include "PalpateDisplayModule.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// The surface itself where its points have normals; otherwise one with the same points and
/// triangles that has them.
PALPATEDISPLAY_EXPORT vtkSmartPointer<vtkPolyData> WithNormals(vtkPolyData* surface);
} // namespace palpate
