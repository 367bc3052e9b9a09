#pragma once

#include "PalpateInteractionModule.h"
#include "Vector3.h"

class vtkCamera;
class vtkRenderer;

namespace palpate
{
/// The camera's axes in the world, as columns: right, up, towards the viewer. Orthonormal to
/// rounding.
PALPATEINTERACTION_EXPORT Matrix3 CameraAxes(vtkCamera* camera);

/// How many mm of the world, across the view, a pixel shows in the plane through a point.
PALPATEINTERACTION_EXPORT double MillimetersPerPixel(vtkRenderer* renderer,
                                                     const Vector3& pointWorld);
} // namespace palpate
