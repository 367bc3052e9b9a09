#include "RightHandedAxes.h"

#include "Refusal.h"

#include <Eigen/LU>
#include <algorithm>
#include <cstddef>

namespace palpate
{
namespace
{
// The largest entry of an axis' unit vector gives its main patient axis.
int AxisToReverse(const Eigen::Matrix3d& direction)
{
  int chosen = 2;
  double most = 0.0;
  for (int axis = 2; axis >= 0; --axis)
  {
    Eigen::Index row = 0;
    direction.col(axis).cwiseAbs().maxCoeff(&row);
    // A difference below rounding counts as a tie, which the later axis wins.
    if (direction(row, axis) < most - 1e-9)
    {
      most = direction(row, axis);
      chosen = axis;
    }
  }
  return chosen;
}

// Reverses the order of `count` blocks.
void ReverseBlocks(unsigned char* data, std::size_t blockBytes, std::size_t count)
{
  for (std::size_t low = 0, high = count - 1; low < high; ++low, --high)
  {
    std::swap_ranges(data + low * blockBytes, data + (low + 1) * blockBytes,
                     data + high * blockBytes);
  }
}

void ReverseAxis(const ImageGrid& grid, int axis, vtkDataArray* voxels)
{
  std::size_t blockBytes = static_cast<std::size_t>(voxels->GetDataTypeSize()) *
                           static_cast<std::size_t>(voxels->GetNumberOfComponents());
  for (int lower = 0; lower < axis; ++lower)
  {
    blockBytes *= static_cast<std::size_t>(grid.Size[static_cast<std::size_t>(lower)]);
  }
  const auto count = static_cast<std::size_t>(grid.Size[static_cast<std::size_t>(axis)]);
  const std::size_t total = static_cast<std::size_t>(voxels->GetDataTypeSize()) *
                            static_cast<std::size_t>(voxels->GetNumberOfValues());
  auto* data = static_cast<unsigned char*>(voxels->GetVoidPointer(0));
  for (std::size_t start = 0; start < total; start += blockBytes * count)
  {
    ReverseBlocks(data + start, blockBytes, count);
  }
}
} // namespace

void MakeRightHanded(const std::filesystem::path& file, LeftHandedAxes handling, ImageGrid& grid,
                     vtkDataArray* voxels, std::vector<std::string>& notes)
{
  if (grid.Direction.determinant() > 0.0)
  {
    return;
  }
  if (handling == LeftHandedAxes::Refuse)
  {
    Refuse(file, "has left-handed directions",
           "allow them (without --refuse-left-handed an axis is reversed), or correct its header");
  }
  const int axis = AxisToReverse(grid.Direction);
  ReverseAxis(grid, axis, voxels);
  const int last = grid.Size[static_cast<std::size_t>(axis)] - 1;
  grid.OriginWorld += last * grid.Spacing[axis] * grid.Direction.col(axis);
  grid.Direction.col(axis) *= -1.0;
  notes.push_back("The axes were left-handed: index axis " + std::to_string(axis + 1) +
                  " was reversed; every voxel keeps its place in the patient.");
}
} // namespace palpate
