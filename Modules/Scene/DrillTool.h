#pragma once

#include "CutTool.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"
#include "ToolShape.h"

namespace palpate
{
/// The cutting volume of a scene's tool. Throws InputError if the tool encloses no volume.
PALPATESCENE_EXPORT CutTool MakeCutTool(const TouchToolSettings& settings);

/// The tool's shape for contact while drilling: smaller by `clearance` (mm) on all sides.
PALPATESCENE_EXPORT ToolShape MakeClearTool(const ToolShape& tool, double clearance);

/// Radius (mm) at which a turning tool slides over the material, and by which it has to rise to
/// leave its own pit.
PALPATESCENE_EXPORT double DrillRadius(const TouchToolSettings& settings, const CutTool& tool);
} // namespace palpate
