#pragma once

#include "LabelImages.h"
#include "SurfaceTessellation.h"
#include "WindingNumbers.h"

#include <stdexcept>

namespace palpate::test
{
/// A label map with 1 at the voxel centres inside of the surface. `grid` gives spacing and
/// direction; its size and origin are made to hold the surface with two voxels around it.
inline vtkSmartPointer<vtkImageData> SurfaceModelMask(const SurfaceModel& surface, LabelGrid grid)
{
  const IndexedMesh mesh =
      Tessellated(surface, IcosahedronDirections(60)); // facets within some micrometres
  const Matrix3 direction =
      Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(grid.Direction.data());
  const Vector3 spacing(grid.Spacing[0], grid.Spacing[1], grid.Spacing[2]);
  Eigen::AlignedBox3d box; // along the grid's axes
  for (const Vector3& point : mesh.Points)
  {
    box.extend(Vector3(direction.transpose() * point));
  }
  constexpr double Margin = 2.3; // voxels; off the grid's symmetry
  const Vector3 origin = direction * (box.min() - Margin * spacing);
  VoxelCenters centers;
  for (int axis = 0; axis < 3; ++axis)
  {
    const auto at = static_cast<std::size_t>(axis);
    grid.Origin[at] = origin[axis];
    grid.Size[at] = static_cast<int>(std::ceil(box.sizes()[axis] / spacing[axis] + 2.0 * Margin));
    centers.Axes.col(axis) = spacing[axis] * direction.col(axis);
  }
  centers.Origin = origin;
  centers.Size = grid.Size;
  std::vector<std::int16_t> numbers;
  const Status status = FindWindingNumbers(mesh, centers, numbers);
  if (!status.IsOk())
  {
    throw std::runtime_error(status.Message());
  }
  auto image = MakeLabelImage(grid, [](double, double, double) { return false; });
  auto* voxels = static_cast<unsigned char*>(image->GetScalarPointer());
  for (const std::int16_t number : numbers)
  {
    *voxels++ = number > 0 ? 1 : 0;
  }
  return image;
}
} // namespace palpate::test
