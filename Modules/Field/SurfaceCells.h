#pragma once

#include "BrickDirectory.h"
#include "FieldMaterial.h"

namespace palpate
{
/// Cells of a brick by what the nodes that they need say about a condition. Interpolated values are
/// means of those nodes with weights that are not negative, so they lie between them.
struct ConditionCells
{
  CellSet Any; ///< it holds at a node at least; elsewhere it holds at no point
  CellSet All; ///< it holds at every node, and so at every point
};

/// For the nodes of one brick, i fastest.
ConditionCells ClassifyCells(const double* nodes, const BrickLayout& layout,
                             const FieldCondition& condition);
/// The same where every node says the same.
ConditionCells UniformCells(bool holds);
} // namespace palpate
