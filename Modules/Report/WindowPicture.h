#pragma once

#include "PalpateReportModule.h"
#include "Picture.h"

class vtkRenderWindow;
class vtkUnsignedCharArray;

namespace palpate
{
/// What a window shows, drawn before.
PALPATEREPORT_EXPORT Picture ReadWindow(vtkRenderWindow* window);
/// The same into a picture of the window's size, through an array; whoever keeps both takes no
/// memory for each picture.
PALPATEREPORT_EXPORT void ReadWindow(vtkRenderWindow* window, vtkUnsignedCharArray* pixels,
                                     Picture& picture);
} // namespace palpate
