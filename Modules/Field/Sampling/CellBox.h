#pragma once

#include "ScalarField.h"

namespace palpate
{
/// A box of a grid's cells, by their lowest nodes; the last ones included.
struct CellBox
{
  int First[3];
  int Last[3];

  bool IsIn(const BrickLayout& layout) const noexcept;
  /// Whether no cell, all of which must be in the grid, may contain a surface or lies in a brick
  /// that a material fills.
  bool IsFree(const ScalarField& field) const noexcept;
};
} // namespace palpate
