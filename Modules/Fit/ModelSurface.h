#pragma once

#include "ModelDocument.h"
#include "PalpateFitModule.h"
#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// Triangulates a model over the icosahedron of a frequency, 10 f^2 + 2 points and 20 f^2 faces in
/// patient LPS (mm), with analytic normals and outward orientation.
PALPATEFIT_EXPORT vtkSmartPointer<vtkPolyData> DrawModel(const SurfaceModel& surface,
                                                         int frequency);
} // namespace palpate
