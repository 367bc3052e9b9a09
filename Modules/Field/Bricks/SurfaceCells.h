#pragma once

#include "BrickDirectory.h"
#include "BrickLayout.h"
#include "CellSet.h"
#include "FieldMaterial.h"

namespace palpate
{
/// Cells of a brick, classified by a condition at the nodes that they need. Interpolated values are
/// means of those nodes with non-negative weights, so they lie between them.
struct ConditionCells
{
  CellSet Any; ///< it holds at one node at least; in other cells it holds nowhere
  CellSet All; ///< it holds at every node, and so at every point

  /// Intersects with another condition.
  void Restrict(const ConditionCells& more);
};

/// For the nodes of one brick, i fastest.
ConditionCells ClassifyCells(const double* nodes, const BrickLayout& layout,
                             const FieldCondition& condition);
/// Removes cells that ClassifyCells left undecided for a cubic B-spline: in each, the coefficients
/// are converted to Bernstein coefficients of the cell, which bound the values more tightly.
void TightenBSplineCells(const double* nodes, const BrickLayout& layout,
                         const FieldCondition& condition, ConditionCells& cells);
/// The result of ClassifyCells if all nodes agree.
ConditionCells UniformCells(bool holds);
/// Adds a material, by the cells of all its conditions together, to a brick: to its surfaces, or to
/// the materials that fill it.
void AddMaterial(int material, const ConditionCells& cells, const CellSet& inGrid,
                 SurfaceBrick& brick);
/// The cells of a brick that lie in the grid; `brick` counts along i, j, k.
CellSet CellsInGrid(const BrickLayout& layout, const std::array<int, 3>& brick);
} // namespace palpate
