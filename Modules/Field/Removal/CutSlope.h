#pragma once

#include "ScalarField.h"

namespace palpate
{
/// Slope (value per mm) of a cut's ramp, so that the remaining surface lies where the tool's was
/// (see NodeCut): the slope of the field's own surface, where both meet; but the ramp must not
/// reach the material's inside value within a cell's diagonal of the tool, because it has to span
/// all corners of the cells that the tool's surface passes. Medians over the field; the condition's
/// channel must be stored inside.
double SlopeOfCuts(const ScalarField& field, const FieldCondition& condition);
} // namespace palpate
