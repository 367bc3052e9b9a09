#pragma once

#include "ScalarField.h"

#include <vector>

namespace palpate
{
/// A channel at all nodes of a field's grid, i fastest: stored values, and elsewhere one near those
/// of the brick, on the same side of every surface.
std::vector<float> NodesOf(const ScalarField& field, int channel);
} // namespace palpate
