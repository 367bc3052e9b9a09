#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// The voxels of one label inside a box.
struct VoxelMask
{
  std::array<int, 3> StartIndex{};   ///< image index of the box's first voxel; the box may extend
                                     ///< beyond the image
  std::array<int, 3> Size{};         ///< voxels along i, j, k
  std::array<double, 3> Spacing{};   ///< mm
  std::vector<unsigned char> Inside; ///< 1 inside, 0 outside; i runs fastest

  std::size_t Offset(int i, int j, int k) const noexcept
  {
    return (static_cast<std::size_t>(k) * static_cast<std::size_t>(this->Size[1]) +
            static_cast<std::size_t>(j)) *
               static_cast<std::size_t>(this->Size[0]) +
           static_cast<std::size_t>(i);
  }
  double VoxelVolume() const noexcept
  {
    return this->Spacing[0] * this->Spacing[1] * this->Spacing[2];
  }
  long long Count() const noexcept
  {
    return std::count(this->Inside.begin(), this->Inside.end(), static_cast<unsigned char>(1));
  }
};

/// The first and last index (inclusive) of the voxels that have a label; first > last if there are
/// none.
struct LabelBounds
{
  std::array<int, 3> First{1, 1, 1};
  std::array<int, 3> Last{0, 0, 0};

  bool IsEmpty() const noexcept { return this->First[0] > this->Last[0]; }
  /// Faces of an image that it reaches: first and last i, j, k.
  std::array<bool, 6> Touches(const std::array<int, 3>& imageSize) const noexcept
  {
    std::array<bool, 6> faces{};
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      faces[2 * axis] = !this->IsEmpty() && this->First[axis] == 0;
      faces[2 * axis + 1] = !this->IsEmpty() && this->Last[axis] == imageSize[axis] - 1;
    }
    return faces;
  }
};

/// Whether one of `count` voxels has a label. Without an early end, so that it is vectorised.
template <typename T>
bool HasLabel(const T* voxels, int count, T wanted)
{
  unsigned char found = 0;
  for (int i = 0; i < count; ++i)
  {
    found |= static_cast<unsigned char>(voxels[i] == wanted);
  }
  return found != 0;
}

template <typename T>
LabelBounds FindLabelBounds(const T* voxels, const std::array<int, 3>& size, T wanted)
{
  LabelBounds bounds;
  bounds.First = size;
  bounds.Last = {-1, -1, -1};
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j, voxels += size[0])
    {
      if (!HasLabel(voxels, size[0], wanted))
      {
        continue;
      }
      const T* first = std::find(voxels, voxels + size[0], wanted);
      const T* last = voxels + size[0] - 1;
      while (*last != wanted)
      {
        --last;
      }
      bounds.First = {std::min(bounds.First[0], static_cast<int>(first - voxels)),
                      std::min(bounds.First[1], j), std::min(bounds.First[2], k)};
      bounds.Last = {std::max(bounds.Last[0], static_cast<int>(last - voxels)),
                     std::max(bounds.Last[1], j), std::max(bounds.Last[2], k)};
    }
  }
  return bounds;
}

/// The voxels that have `label` in a box, not empty, that may extend beyond the image.
template <typename T>
VoxelMask CopyLabel(const T* voxels, const std::array<int, 3>& size,
                    const std::array<double, 3>& spacing, const LabelBounds& box, T label)
{
  VoxelMask mask;
  mask.StartIndex = box.First;
  mask.Spacing = spacing;
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    mask.Size[axis] = box.Last[axis] - box.First[axis] + 1;
    first[axis] = std::max(box.First[axis], 0);
    last[axis] = std::min(box.Last[axis], size[axis] - 1);
  }
  mask.Inside.assign(mask.Offset(0, 0, mask.Size[2]), 0);
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      const T* row = voxels + (static_cast<std::size_t>(k) * static_cast<std::size_t>(size[1]) +
                               static_cast<std::size_t>(j)) *
                                  static_cast<std::size_t>(size[0]);
      std::transform(
          row + first[0], row + last[0] + 1,
          &mask.Inside[mask.Offset(first[0] - box.First[0], j - box.First[1], k - box.First[2])],
          [label](T voxel) { return voxel == label ? 1 : 0; });
    }
  }
  return mask;
}
} // namespace palpate
