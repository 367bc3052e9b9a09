#pragma once

#include "BrickLayout.h"
#include "Vector3.h"

#include <cstddef>

namespace palpate
{
/// The cell that contains a point, its brick, and the point's position in the cell.
struct CellPlace
{
  std::size_t Brick = 0;
  int FirstNode = 0; ///< of the cell in its brick's copy of the nodes
  double U[3] = {};  ///< from 0 to 1 along i, j, k

  /// Returns false outside the grid and for NaN. A point on a face between two cells belongs to the
  /// one of higher index; on the grid's last face to the last cell.
  bool Locate(const BrickLayout& layout, const Vector3& pointIndex) noexcept
  {
    int cell[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double p = pointIndex[axis];
      const auto a = static_cast<std::size_t>(axis);
      const int last = layout.Nodes[a] - 1;
      if (!(p >= 0.0 && p <= last))
      {
        return false;
      }
      const int below = static_cast<int>(p);
      cell[axis] = below < last ? below : last - 1;
      this->U[axis] = p - cell[axis];
    }
    this->Brick = layout.NumberOfCell(cell[0], cell[1], cell[2]);
    this->FirstNode = layout.FirstNodeOfCell(cell[0], cell[1], cell[2]);
    return true;
  }
};
} // namespace palpate
