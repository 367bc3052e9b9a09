#pragma once

#include "Vector3.h"

namespace palpate
{
/// The singular value decomposition of a finite 3 x 3 matrix: Left diag(Values) Right^T, with
/// orthogonal sides, of which each can be a reflection, and values >= 0 from the largest.
struct SingularValues
{
  /// The nearest orthogonal matrix in the Frobenius norm: the polar factor.
  Matrix3 NearestOrthogonal() const { return this->Left * this->Right.transpose(); }

  Matrix3 Left;
  Vector3 Values;
  Matrix3 Right;
};
SingularValues SingularValuesOf(const Matrix3& matrix);
} // namespace palpate
