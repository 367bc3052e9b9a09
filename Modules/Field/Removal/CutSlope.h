#pragma once

#include "ScalarField.h"

namespace palpate
{
/// How steep (value a mm) a cut's ramp is to be, so that the surface that remains lies where the
/// tool's was (see NodeCut): as steep as the field's own surface, where both meet; and no steeper
/// than that the ramp reaches what the material has inside a cell's diagonal from the tool, because
/// the ramp has to go through all corners of the cells that the tool's surface passes. Medians of
/// the field, of which the condition's channel is stored inside.
double SlopeOfCuts(const ScalarField& field, const FieldCondition& condition);
} // namespace palpate
