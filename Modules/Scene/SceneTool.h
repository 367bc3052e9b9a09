#pragma once

#include "CutTool.h"
#include "PalpateSceneModule.h"
#include "ToolShape.h"
#include "TouchToolSettings.h"

namespace palpate
{
/// Builds the tool. Throws InputError if the settings do not describe a valid tool.
PALPATESCENE_EXPORT ToolShape MakeTool(const TouchToolSettings& settings);

/// The cutting volume of a scene's tool. Throws InputError if the tool encloses no volume.
PALPATESCENE_EXPORT CutTool MakeCutTool(const TouchToolSettings& settings);

/// Radius (mm) at which a turning tool slides over the material, and by which it has to rise to
/// leave its own pit.
PALPATESCENE_EXPORT double DrillRadius(const TouchToolSettings& settings, const CutTool& tool);
} // namespace palpate
