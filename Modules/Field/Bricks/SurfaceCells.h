#pragma once

#include "BrickDirectory.h"
#include "BrickLayout.h"
#include "CellSet.h"
#include "FieldMaterial.h"

namespace palpate
{
/// Cells of a brick by what the nodes that they need say about a condition. Interpolated values are
/// means of those nodes with weights that are not negative, so they lie between them.
struct ConditionCells
{
  CellSet Any; ///< it holds at a node at least; elsewhere it holds at no point
  CellSet All; ///< it holds at every node, and so at every point

  /// To where another condition holds too.
  void Restrict(const ConditionCells& more);
};

/// For the nodes of one brick, i fastest.
ConditionCells ClassifyCells(const double* nodes, const BrickLayout& layout,
                             const FieldCondition& condition);
/// Takes cells out of what ClassifyCells left open for a cubic B-spline: in each, its coefficients
/// are turned into Bernstein coefficients of the cell, between which the values lie much closer.
void TightenBSplineCells(const double* nodes, const BrickLayout& layout,
                         const FieldCondition& condition, ConditionCells& cells);
/// What ClassifyCells gives where every node says the same.
ConditionCells UniformCells(bool holds);
/// Adds a material, by the cells of all its conditions together, to what is known of a brick: to
/// its surfaces, or to what fills it.
void AddMaterial(int material, const ConditionCells& cells, const CellSet& inGrid,
                 SurfaceBrick& brick);
/// The cells of a brick that lie in the grid; `brick` counts along i, j, k.
CellSet CellsInGrid(const BrickLayout& layout, const std::array<int, 3>& brick);
} // namespace palpate
