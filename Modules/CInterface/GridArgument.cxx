#include "GridArgument.h"

#include "AvailableMemory.h"
#include "ErrorText.h"

#include <algorithm>
#include <vector>

namespace palpate
{
Status PlaceGrid(const int size[3], const double origin[3], const double spacing[3],
                 const double axes[9], IndexToWorld& toWorld)
{
  const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> rows(axes);
  toWorld.Origin = VectorOf(origin);
  toWorld.Axes = rows.transpose() * VectorOf(spacing).asDiagonal();
  const bool isUnit = (rows * rows.transpose() - Matrix3::Identity()).norm() < 1e-4;
  const bool isPlaced = isUnit && toWorld.Origin.allFinite() && toWorld.Axes.allFinite();
  return isPlaced && size[0] > 0 && size[1] > 0 && size[2] > 0 && VectorOf(spacing).minCoeff() > 0.0
             ? Status::Success()
             : Status::Failure(
                   "a grid has voxels, a finite origin, spacings above 0, and axes that "
                   "are unit vectors at right angles");
}

void CheckVoxels(const int size[3])
{
  CheckMemory("the grid", static_cast<double>(size[0]) * size[1] * size[2]);
}

VoxelMask CroppedMask(const uint8_t* inside, const int size[3], const double spacing[3])
{
  CheckVoxels(size);
  std::vector<uint8_t> ones(static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]) *
                            static_cast<std::size_t>(size[2]));
  std::transform(inside, inside + ones.size(), ones.begin(),
                 [](uint8_t voxel) { return voxel != 0 ? 1 : 0; });
  return CroppedLabel<uint8_t>(ones.data(), size, spacing, 1);
}
} // namespace palpate
