#pragma once

#include "CutTool.h"
#include "PalpateSessionModule.h"
#include "SceneSettings.h"
#include "ToolShape.h"

namespace palpate
{
/// A scene's tool as what cuts. Throws InputError where it has no inside.
PALPATESESSION_EXPORT CutTool MakeCutTool(const TouchToolSettings& settings);

/// The same tool as what touches beside it: smaller by `clearance` (mm) all round.
PALPATESESSION_EXPORT ToolShape MakeClearTool(const ToolShape& tool, double clearance);

/// mm at which a tool rubs, and by which it rises out of its own pit.
PALPATESESSION_EXPORT double DrillRadius(const TouchToolSettings& settings, const CutTool& tool);
} // namespace palpate
