#pragma once

#include "FieldSamples.h"
#include "NodeCut.h"
#include "RemovedDistances.h"

namespace palpate
{
/// Samples with `removed` cut out, for each node of its grid, i fastest: `original` gives a box of
/// nodes and the value outside it; `drilled` is an array of the same type. Computed as the field
/// does in `kept`, Float32 or Float64. Integers are rounded to the nearest value of their type;
/// samples that no cut changes are unchanged.
void WriteDrilledSamples(const RemovedDistances& removed, const NodeCut& cut, ScalarType kept,
                         const FieldSamples& original, void* drilled);
} // namespace palpate
