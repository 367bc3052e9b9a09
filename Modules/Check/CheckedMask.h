#pragma once

#include "IndexToWorld.h"
#include "Vector3.h"
#include "VoxelMask.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// A mask that is judged: the voxels of a structure in a box with a rim of one voxel outside, their
/// place in the world (patient LPS, mm), and the size of their image.
struct CheckedMask
{
  VoxelMask Voxels;
  IndexToWorld ToWorld; ///< of image indices
  std::array<int, 3> ImageSize{};

  /// World of a continuous index of the box.
  Vector3 WorldOfBox(const Vector3& index) const
  {
    const std::array<int, 3>& start = this->Voxels.StartIndex;
    return this->ToWorld(index + Vector3(start[0], start[1], start[2]));
  }
  /// Of the voxels, world; the box's centre without voxels.
  Vector3 Centroid() const;
};

/// The voxels of all masks, which have one grid; at least one mask.
CheckedMask UnionOf(const std::vector<CheckedMask>& masks);

/// The same mask with its axes in another order, the slices (largest spacing) along the last one;
/// as it is if the spacings are equal to 1 %.
CheckedMask WithSlicesLast(CheckedMask mask);

/// The same mask on coarser voxels if its box has more than `most` voxels: every second one along
/// the axis of the smallest spacing, repeatedly. A coarse voxel is inside if half of its voxels
/// are.
CheckedMask Coarsened(CheckedMask mask, std::size_t most);

/// The side of the patient to which a direction points most: index into the letters "LRPASI".
int PatientSideOf(const Vector3& direction);
} // namespace palpate
