#pragma once

#include "PalpateSessionModule.h"
#include "ToolShape.h"
#include "TouchToolSettings.h"

namespace palpate
{
/// Builds the tool. Throws InputError if the settings do not describe a valid tool.
PALPATESESSION_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);
} // namespace palpate
