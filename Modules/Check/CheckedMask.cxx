#include "CheckedMask.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
VoxelMask EmptyLike(const VoxelMask& mask, const std::array<int, 3>& size)
{
  VoxelMask made;
  made.StartIndex = mask.StartIndex;
  made.Spacing = mask.Spacing;
  made.Size = size;
  made.Inside.assign(made.Offset(0, 0, size[2]), 0);
  return made;
}

// With the axes `a` and 2 exchanged.
CheckedMask Exchanged(const CheckedMask& mask, std::size_t a)
{
  const VoxelMask& from = mask.Voxels;
  CheckedMask made = mask;
  std::array<int, 3> size = from.Size;
  std::swap(size[a], size[2]);
  made.Voxels = EmptyLike(from, size);
  std::swap(made.Voxels.StartIndex[a], made.Voxels.StartIndex[2]);
  std::swap(made.Voxels.Spacing[a], made.Voxels.Spacing[2]);
  std::swap(made.ImageSize[a], made.ImageSize[2]);
  made.ToWorld.Axes.col(static_cast<Eigen::Index>(a)).swap(made.ToWorld.Axes.col(2));
  std::size_t at = 0;
  for (int k = 0; k < from.Size[2]; ++k)
  {
    for (int j = 0; j < from.Size[1]; ++j)
    {
      for (int i = 0; i < from.Size[0]; ++i)
      {
        made.Voxels.Inside[a == 0 ? made.Voxels.Offset(k, j, i) : made.Voxels.Offset(i, k, j)] =
            from.Inside[at++];
      }
    }
  }
  return made;
}

CheckedMask Halved(const CheckedMask& mask, std::size_t axis)
{
  const VoxelMask& from = mask.Voxels;
  CheckedMask made = mask;
  std::array<int, 3> size = from.Size;
  size[axis] = (size[axis] + 1) / 2 + 1; // keeps an empty rim behind
  made.Voxels = EmptyLike(from, size);
  made.Voxels.Spacing[axis] *= 2.0;
  // Coarse voxel n holds the voxels 2n - 1 and 2n, so that the first one is empty.
  const auto column = static_cast<Eigen::Index>(axis);
  const Vector3 step = made.ToWorld.Axes.col(column);
  made.ToWorld.Origin += step * (from.StartIndex[axis] - 0.5);
  made.ToWorld.Axes.col(column) = 2.0 * step;
  made.Voxels.StartIndex[axis] = 0;
  made.ImageSize[axis] = -1; // the border is judged on the mask as it was
  const auto isInside = [&](std::array<int, 3> at)
  {
    return at[axis] >= 0 && at[axis] < from.Size[axis] &&
           from.Inside[from.Offset(at[0], at[1], at[2])] != 0;
  };
  std::array<int, 3> at{};
  for (at[2] = 0; at[2] < size[2]; ++at[2])
  {
    for (at[1] = 0; at[1] < size[1]; ++at[1])
    {
      for (at[0] = 0; at[0] < size[0]; ++at[0])
      {
        std::array<int, 3> first = at;
        first[axis] = 2 * at[axis] - 1;
        std::array<int, 3> second = at;
        second[axis] = 2 * at[axis];
        made.Voxels.Inside[made.Voxels.Offset(at[0], at[1], at[2])] =
            isInside(first) || isInside(second) ? 1 : 0;
      }
    }
  }
  return made;
}
} // namespace

Vector3 CheckedMask::Centroid() const
{
  const VoxelMask& mask = this->Voxels;
  Vector3 sum = Vector3::Zero();
  double count = 0.0;
  std::size_t at = 0;
  for (int k = 0; k < mask.Size[2]; ++k)
  {
    for (int j = 0; j < mask.Size[1]; ++j)
    {
      double inRow = 0.0;
      for (int i = 0; i < mask.Size[0]; ++i)
      {
        const double one = mask.Inside[at++];
        inRow += one;
        sum[0] += one * i;
      }
      sum[1] += inRow * j;
      sum[2] += inRow * k;
      count += inRow;
    }
  }
  const Vector3 middle =
      0.5 * (Vector3(mask.Size[0], mask.Size[1], mask.Size[2]) - Vector3::Ones());
  return this->WorldOfBox(count > 0.0 ? Vector3(sum / count) : middle);
}

CheckedMask UnionOf(const std::vector<CheckedMask>& masks)
{
  std::array<int, 3> first = masks.front().Voxels.StartIndex;
  std::array<int, 3> end = first;
  for (const CheckedMask& mask : masks)
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int start = mask.Voxels.StartIndex[axis];
      first[axis] = std::min(first[axis], start);
      end[axis] = std::max(end[axis], start + mask.Voxels.Size[axis]);
    }
  }
  CheckedMask made = masks.front();
  made.Voxels = EmptyLike(made.Voxels, {end[0] - first[0], end[1] - first[1], end[2] - first[2]});
  made.Voxels.StartIndex = first;
  for (const CheckedMask& mask : masks)
  {
    const VoxelMask& from = mask.Voxels;
    std::size_t at = 0;
    for (int k = 0; k < from.Size[2]; ++k)
    {
      for (int j = 0; j < from.Size[1]; ++j)
      {
        for (int i = 0; i < from.Size[0]; ++i)
        {
          made.Voxels.Inside[made.Voxels.Offset(
              i + from.StartIndex[0] - first[0], j + from.StartIndex[1] - first[1],
              k + from.StartIndex[2] - first[2])] |= from.Inside[at++];
        }
      }
    }
  }
  return made;
}

CheckedMask WithSlicesLast(CheckedMask mask)
{
  const std::array<double, 3>& spacing = mask.Voxels.Spacing;
  const auto thickest =
      static_cast<std::size_t>(std::max_element(spacing.begin(), spacing.end()) - spacing.begin());
  return thickest == 2 || spacing[thickest] < 1.01 * spacing[2] ? std::move(mask)
                                                                : Exchanged(mask, thickest);
}

CheckedMask Coarsened(CheckedMask mask, std::size_t most)
{
  while (mask.Voxels.Inside.size() > most)
  {
    const std::array<double, 3>& spacing = mask.Voxels.Spacing;
    const auto finest = static_cast<std::size_t>(std::min_element(spacing.begin(), spacing.end()) -
                                                 spacing.begin());
    if (mask.Voxels.Size[finest] < 8)
    {
      return mask; // a plate
    }
    mask = Halved(mask, finest);
  }
  return mask;
}

int PatientSideOf(const Vector3& direction)
{
  Eigen::Index axis = 0;
  direction.cwiseAbs().maxCoeff(&axis);
  return 2 * static_cast<int>(axis) + (direction[axis] > 0.0 ? 0 : 1);
}
} // namespace palpate
