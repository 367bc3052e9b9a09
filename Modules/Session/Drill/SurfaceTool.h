#pragma once

#include "CutTool.h"
#include "PalpateSessionModule.h"
#include "ToolShape.h"

#include <filesystem>

namespace palpate
{
/// Tools of any shape: a closed surface from a file (mm, in the tool's own frame, its tip or
/// middle at the origin as the file has it). Throw InputError for files that are none and for
/// surfaces that are not closed.

/// What touches: `count` of the surface's points, as far from each other as they can be.
PALPATESESSION_EXPORT ToolShape MakeSurfaceTool(const std::filesystem::path& file, int count);

/// What cuts: all that is inside.
PALPATESESSION_EXPORT CutTool MakeSurfaceCutTool(const std::filesystem::path& file);
} // namespace palpate
