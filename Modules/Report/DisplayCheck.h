#pragma once

#include "PalpateReportModule.h"

namespace palpate
{
/// Throws std::runtime_error, with the fix, unless DISPLAY names an X server that answers and has
/// GLX. Otherwise VTK's OpenGL windows and Qt end the process, so call this before creating any.
/// Main thread only.
PALPATEREPORT_EXPORT void RequireDisplay();
} // namespace palpate
