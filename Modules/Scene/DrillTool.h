#pragma once

#include "CutTool.h"
#include "PalpateSceneModule.h"
#include "SceneSettings.h"
#include "ToolShape.h"

namespace palpate
{
/// A scene's tool as what cuts. Throws InputError where it has no inside.
PALPATESCENE_EXPORT CutTool MakeCutTool(const TouchToolSettings& settings);

/// The same tool as what touches beside it: smaller by `clearance` (mm) all round.
PALPATESCENE_EXPORT ToolShape MakeClearTool(const ToolShape& tool, double clearance);

/// mm at which a tool rubs, and by which it rises out of its own pit.
PALPATESCENE_EXPORT double DrillRadius(const TouchToolSettings& settings, const CutTool& tool);
} // namespace palpate
