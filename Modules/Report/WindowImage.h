#pragma once

#include "PalpateReportModule.h"
#include "RasterImage.h"

class vtkRenderWindow;
class vtkUnsignedCharArray;

namespace palpate
{
/// Reads the image that a window has rendered.
PALPATEREPORT_EXPORT RasterImage ReadWindow(vtkRenderWindow* window);
/// The same into an image of the window's size, through an array; reusing both avoids allocations.
PALPATEREPORT_EXPORT void ReadWindow(vtkRenderWindow* window, vtkUnsignedCharArray* pixels,
                                     RasterImage& raster);
} // namespace palpate
