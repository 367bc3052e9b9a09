#pragma once

#include "IndexToWorld.h"
#include "Status.h"
#include "VoxelMask.h"

#include <array>
#include <cstddef>
#include <cstdint>

namespace palpate
{
/// Places a grid whose axes may be left-handed. Fails for one without voxels, and for an origin, a
/// spacing or axes that describe no grid.
Status PlaceGrid(const int size[3], const double origin[3], const double spacing[3],
                 const double axes[9], IndexToWorld& toWorld);

/// Throws InputError if the machine cannot hold a byte for each voxel: then the size is wrong.
void CheckVoxels(const int size[3]);

/// The voxels of a label, with a voxel around them; empty if there are none.
template <typename T>
VoxelMask CroppedLabel(const T* voxels, const int size[3], const double spacing[3], T label)
{
  const std::array<int, 3> of{size[0], size[1], size[2]};
  LabelBounds box = FindLabelBounds<T>(voxels, of, label);
  if (box.IsEmpty())
  {
    return {};
  }
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    --box.First[axis];
    ++box.Last[axis];
  }
  return CopyLabel<T>(voxels, of, {spacing[0], spacing[1], spacing[2]}, box, label);
}

/// What is inside (not 0), with a voxel around it; empty if there is nothing.
/// Throws InputError as CheckVoxels does.
VoxelMask CroppedMask(const std::uint8_t* inside, const int size[3], const double spacing[3]);
} // namespace palpate
