#pragma once

#include "PalpateSceneModule.h"
#include "ToolShape.h"
#include "TouchToolSettings.h"

namespace palpate
{
/// Builds the tool. Throws InputError if the settings do not describe a valid tool.
PALPATESCENE_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);
} // namespace palpate
