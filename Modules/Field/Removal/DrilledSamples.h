#pragma once

#include "FieldSamples.h"
#include "NodeCut.h"
#include "RemovedDistances.h"

namespace palpate
{
/// What samples are once `removed` is cut out of them, for each node of its grid, i fastest: what
/// `original` says of a box of nodes and what lies outside of it, in an array of the same type.
/// Computed as the field does in `kept`, Float32 or Float64. Whole numbers are rounded to the
/// nearest one of their type; samples that no cut changes stay as they are.
void WriteDrilledSamples(const RemovedDistances& removed, const NodeCut& cut, ScalarType kept,
                         const FieldSamples& original, void* drilled);
} // namespace palpate
