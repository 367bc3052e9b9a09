#pragma once

#include "IndexToWorld.h"
#include "VoxelMask.h"

#include <array>

namespace palpate::test
{
/// Voxels of 1 x 1 x 2 mm, and their image of 64 x 64 x 32.
constexpr std::array<int, 3> CorrectedImage{64, 64, 32};
inline const std::array<double, 3> CorrectedSpacing{1.0, 1.0, 2.0};

inline IndexToWorld CorrectedFrame()
{
  return {Vector3(-32.0, -31.0, 5.0), Vector3(1.0, 1.0, 2.0).asDiagonal()};
}

/// The voxels for which `isInside` (of a world point) holds, in the image's box and a rim.
template <typename Predicate>
VoxelMask MaskWhere(const Predicate& isInside)
{
  VoxelMask mask;
  mask.StartIndex = {-1, -1, -1};
  mask.Size = {CorrectedImage[0] + 2, CorrectedImage[1] + 2, CorrectedImage[2] + 2};
  mask.Spacing = CorrectedSpacing;
  mask.Inside.assign(mask.Offset(0, 0, mask.Size[2]), 0);
  const IndexToWorld toWorld = CorrectedFrame();
  for (int k = 0; k < CorrectedImage[2]; ++k)
  {
    for (int j = 0; j < CorrectedImage[1]; ++j)
    {
      for (int i = 0; i < CorrectedImage[0]; ++i)
      {
        mask.Inside[mask.Offset(i + 1, j + 1, k + 1)] = isInside(toWorld(Vector3(i, j, k))) ? 1 : 0;
      }
    }
  }
  return mask;
}

/// The image's centre, mm.
inline Vector3 CorrectedMiddle()
{
  return CorrectedFrame()(Vector3(32.0, 31.0, 16.0));
}

inline VoxelMask BallMask(double radius)
{
  return MaskWhere([radius](const Vector3& point)
                   { return (point - CorrectedMiddle()).norm() < radius; });
}

/// Calls `visit` with each voxel of the image and its centre (world mm).
template <typename Visit>
void ForEachVoxel(const Visit& visit)
{
  const IndexToWorld toWorld = CorrectedFrame();
  for (int k = 0; k < CorrectedImage[2]; ++k)
  {
    for (int j = 0; j < CorrectedImage[1]; ++j)
    {
      for (int i = 0; i < CorrectedImage[0]; ++i)
      {
        visit(std::array<int, 3>{i, j, k}, toWorld(Vector3(i, j, k)));
      }
    }
  }
}
} // namespace palpate::test
