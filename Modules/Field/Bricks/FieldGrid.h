#pragma once

#include "Status.h"
#include "Vector3.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Geometry of a field's nodes in the world (patient LPS, mm). The index of a node is a whole
/// number along i, j, k, each from 0; points between nodes have continuous indices, from 0 to size
/// - 1. Columns of `direction` are the axes in world coordinates.
class FieldGrid
{
public:
  FieldGrid() = default;
  FieldGrid(const std::array<int, 3>& size, const Vector3& originWorld, const Vector3& spacing,
            const Matrix3& direction);

  /// Fails for fewer than 2 or more than 65,536 nodes along an axis, spacings that are not
  /// positive, and a direction that is not orthonormal (to 1e-4) and right-handed.
  Status Check() const;

  const std::array<int, 3>& Size() const noexcept { return this->Nodes; }
  std::size_t NodeCount() const noexcept;
  const Vector3& OriginWorld() const noexcept { return this->Origin; }
  const Vector3& Spacing() const noexcept { return this->Steps; }
  const Matrix3& Direction() const noexcept { return this->Axes; }

  /// Applied to point - origin, mm.
  const Matrix3& WorldToIndex() const noexcept { return this->ToIndex; }

  Vector3 PointWorld(const Vector3& pointIndex) const noexcept
  {
    return this->Origin + this->ToWorld * pointIndex;
  }
  Vector3 PointIndex(const Vector3& pointWorld) const noexcept
  {
    // Written out, so that kernels with the same operations give the same bits.
    const Vector3 d = pointWorld - this->Origin;
    const Matrix3& m = this->ToIndex;
    return {m(0, 0) * d[0] + m(0, 1) * d[1] + m(0, 2) * d[2],
            m(1, 0) * d[0] + m(1, 1) * d[1] + m(1, 2) * d[2],
            m(2, 0) * d[0] + m(2, 1) * d[1] + m(2, 2) * d[2]};
  }
  Vector3 VectorWorld(const Vector3& vectorIndex) const noexcept
  {
    return this->ToWorld * vectorIndex;
  }
  Vector3 VectorIndex(const Vector3& vectorWorld) const noexcept
  {
    return this->ToIndex * vectorWorld;
  }
  /// From change per voxel to change per mm: the transposed inverse of the matrix for vectors.
  Vector3 GradientWorld(const Vector3& gradientIndex) const noexcept
  {
    return this->ToIndex.transpose() * gradientIndex;
  }

private:
  std::array<int, 3> Nodes{};
  Vector3 Origin = Vector3::Zero();
  Vector3 Steps = Vector3::Ones();
  Matrix3 Axes = Matrix3::Identity();
  Matrix3 ToWorld = Matrix3::Identity();
  Matrix3 ToIndex = Matrix3::Identity();
};
} // namespace palpate
