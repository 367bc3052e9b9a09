#pragma once

#include "PalpateReportModule.h"

namespace palpate
{
/// Throws std::runtime_error, naming the way out, unless DISPLAY names an X server that answers and
/// has GLX. VTK's OpenGL windows and Qt end the process in that case, so this is called before any
/// is made. Main thread only.
PALPATEREPORT_EXPORT void RequireDisplay();
} // namespace palpate
