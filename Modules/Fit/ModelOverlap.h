#pragma once

#include "FitResult.h"
#include "WindingNumbers.h"

namespace palpate
{
/// Compares the drawn model with the voxels of the structure on the mask's own grid; for a surface
/// file on about a million cubes around it, whose side becomes DiceSpacing. Stores Dice.
WindingOverlap MeasureOverlap(FitResult& result);
} // namespace palpate
