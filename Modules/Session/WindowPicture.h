#pragma once

#include "PalpateSessionModule.h"
#include "Picture.h"

class vtkRenderWindow;

namespace palpate
{
/// What a window shows, drawn before.
PALPATESESSION_EXPORT Picture ReadWindow(vtkRenderWindow* window);
} // namespace palpate
