#pragma once

#include "ScalarField.h"

namespace palpate
{
/// Cells of a grid side by side, by their lowest nodes; the last ones included.
struct CellBox
{
  int First[3];
  int Last[3];

  bool IsIn(const BrickLayout& layout) const noexcept;
  /// Whether none of the cells, which have to be in the grid, is one that a surface
  /// may pass or lies in a brick that a material fills.
  bool IsFree(const ScalarField& field) const noexcept;
};
} // namespace palpate
