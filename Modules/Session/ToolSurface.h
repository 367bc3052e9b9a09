#pragma once

#include "PalpateSessionModule.h"
#include "TouchSettings.h"

#include "vtkPolyData.h"
#include "vtkSmartPointer.h"

namespace palpate
{
/// A tool as it is drawn: a closed surface in its own frame, mm, along z. A length of 0 is drawn as
/// half a millimetre, so that a point is seen.
PALPATESESSION_EXPORT vtkSmartPointer<vtkPolyData> MakeToolSurface(const TouchToolSettings& tool);
} // namespace palpate
