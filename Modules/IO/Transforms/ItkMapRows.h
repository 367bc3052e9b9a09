#pragma once

#include "MapRows.h"

#include "itkMatrixOffsetTransformBase.h"

namespace palpate
{
/// Three rows of a matrix and a shift, of a linear transform of ITK.
inline MapRows RowsOf(const itk::MatrixOffsetTransformBase<double, 3, 3>& linear)
{
  MapRows rows{};
  for (unsigned row = 0; row < 3; ++row)
  {
    for (unsigned column = 0; column < 3; ++column)
    {
      rows[row][column] = linear.GetMatrix()(row, column);
    }
    rows[row][3] = linear.GetOffset()[row];
  }
  return rows;
}
} // namespace palpate
