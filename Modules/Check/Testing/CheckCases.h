#pragma once

#include "CheckedMask.h"
#include "MaskStatistic.h"

#include <algorithm>
#include <array>
#include <functional>
#include <limits>
#include <string>

namespace palpate::test
{
/// A mask on an image of this size and spacing (mm; axes L, P, S, origin 0): where `isInside` is
/// true of a voxel's centre in mm. Its box is the whole image with a rim.
inline CheckedMask MakeMask(const std::array<int, 3>& size, const std::array<double, 3>& spacing,
                            const std::function<bool(const Vector3&)>& isInside)
{
  CheckedMask mask;
  mask.ImageSize = size;
  mask.ToWorld.Axes = Vector3(spacing[0], spacing[1], spacing[2]).asDiagonal();
  mask.Voxels.StartIndex = {-1, -1, -1};
  mask.Voxels.Spacing = spacing;
  mask.Voxels.Size = {size[0] + 2, size[1] + 2, size[2] + 2};
  mask.Voxels.Inside.assign(mask.Voxels.Offset(0, 0, size[2] + 2), 0);
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        mask.Voxels.Inside[mask.Voxels.Offset(i + 1, j + 1, k + 1)] =
            isInside({i * spacing[0], j * spacing[1], k * spacing[2]}) ? 1 : 0;
      }
    }
  }
  return mask;
}

/// A ball of 16 mm around (20, 20, 20) in slices of 2 mm, without what `isOut` is true of.
inline CheckedMask MakeBall(const std::function<bool(const Vector3&)>& isOut = {})
{
  return MakeMask({41, 41, 21}, {1.0, 1.0, 2.0},
                  [&](const Vector3& at)
                  { return (at - Vector3(20, 20, 20)).norm() <= 16.0 && !(isOut && isOut(at)); });
}

/// NaN, which fails every comparison, if there is none.
inline MaskStatistic Find(const MaskStatistics& statistics, const std::string& key)
{
  const auto found = std::find_if(statistics.begin(), statistics.end(),
                                  [&](const MaskStatistic& one) { return one.Key == key; });
  const double none = std::numeric_limits<double>::quiet_NaN();
  return found != statistics.end() ? *found
                                   : MaskStatistic{key, none, Vector3::Constant(none), none};
}
} // namespace palpate::test
