#pragma once

#include "PalpateReportModule.h"
#include "RasterImage.h"

class vtkRenderWindow;

namespace palpate
{
/// Reads the image that a window has rendered.
PALPATEREPORT_EXPORT RasterImage ReadWindow(vtkRenderWindow* window);
} // namespace palpate
