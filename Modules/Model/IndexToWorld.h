#pragma once

#include "Vector3.h"

namespace palpate
{
/// Places image indices in the world (patient LPS, mm).
struct IndexToWorld
{
  Vector3 Origin = Vector3::Zero();   ///< of index (0, 0, 0)
  Matrix3 Axes = Matrix3::Identity(); ///< columns: one step along i, j and k

  Vector3 operator()(const Vector3& index) const { return this->Origin + this->Axes * index; }
};
} // namespace palpate
