#pragma once

#include "PalpateInteractionModule.h"
#include "Vector3.h"

class vtkCamera;

namespace palpate
{
/// The camera's axes in the world, as columns: right, up, towards the viewer. Orthonormal to
/// rounding.
PALPATEINTERACTION_EXPORT Matrix3 CameraAxes(vtkCamera* camera);
} // namespace palpate
