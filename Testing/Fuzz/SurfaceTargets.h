#pragma once

#include "FuzzTarget.h"

namespace palpate::test
{
/// Surfaces (VTP, STL, PLY, OBJ, glTF, GIfTI) and models (JSON, CSV, SPHARM-PDM).
std::vector<FuzzTarget> SurfaceTargets();
} // namespace palpate::test
