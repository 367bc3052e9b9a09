#include "OrthogonalResampling.h"

#include "AvailableMemory.h"

#include "vtkDataArray.h"
#include "vtkImageReslice.h"
#include "vtkMatrix4x4.h"
#include "vtkNew.h"
#include "vtkPointData.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>

namespace palpate
{
namespace
{
// From voxel indices to steps in the world, mm.
Eigen::Matrix3d StepsOf(const ImageGrid& grid)
{
  return grid.Direction * grid.Spacing.asDiagonal();
}

// The perpendicular grid around a sheared one.
ImageGrid GridAround(const ImageGrid& sheared)
{
  ImageGrid grid;
  grid.Direction.col(0) = sheared.Direction.col(0).normalized();
  const Vector3 second = sheared.Direction.col(1);
  grid.Direction.col(1) =
      (second - second.dot(grid.Direction.col(0)) * grid.Direction.col(0)).normalized();
  grid.Direction.col(2) = grid.Direction.col(0).cross(grid.Direction.col(1));
  // Distances of the sheared planes along the new axes.
  grid.Spacing = (grid.Direction.transpose() * StepsOf(sheared)).diagonal().cwiseAbs();
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
  {
    Vector3 index;
    for (int axis = 0; axis < 3; ++axis)
    {
      const int last = sheared.Size[static_cast<std::size_t>(axis)] - 1;
      index[axis] = (corner >> axis) % 2 == 0 ? 0.0 : last;
    }
    const Vector3 moved = grid.Direction.transpose() * StepsOf(sheared) * index;
    box.extend(Eigen::Vector3d(moved.cwiseQuotient(grid.Spacing)));
  }
  // Up to rounding, so that planes that both grids share need no interpolation.
  constexpr double Rounding = 1e-6;
  const Vector3 first = (box.min().array() + Rounding).floor();
  const Vector3 last = (box.max().array() - Rounding).ceil();
  for (int axis = 0; axis < 3; ++axis)
  {
    grid.Size[static_cast<std::size_t>(axis)] = static_cast<int>(last[axis] - first[axis]) + 1;
  }
  grid.OriginWorld = sheared.OriginWorld + grid.Direction * first.cwiseProduct(grid.Spacing);
  return grid;
}

} // namespace

Eigen::Affine3d IndexMap(const ImageGrid& from, const Eigen::Affine3d& steps)
{
  Eigen::Affine3d own = Eigen::Affine3d::Identity();
  own.linear() = StepsOf(from);
  own.translation() = from.OriginWorld;
  return own.inverse() * steps;
}

vtkSmartPointer<vtkDataArray> ResampledVoxels(const std::filesystem::path& file,
                                              vtkImageData* image, const std::array<int, 3>& size,
                                              const Eigen::Affine3d& indices, ResamplingKind kind)
{
  vtkDataArray* voxels = image->GetPointData()->GetScalars();
  const double count = static_cast<double>(size[0]) * size[1] * size[2];
  CheckMemory(file, count * voxels->GetDataTypeSize());
  // In indices, since VTK 9.1's filter ignores directions.
  vtkNew<vtkImageData> indexed;
  indexed->SetDimensions(image->GetDimensions());
  indexed->GetPointData()->SetScalars(voxels);
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows = indices.matrix();
  vtkNew<vtkMatrix4x4> axes;
  axes->DeepCopy(rows.data());
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(indexed);
  reslice->SetResliceAxes(axes);
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputExtent(0, size[0] - 1, 0, size[1] - 1, 0, size[2] - 1);
  reslice->SetInterpolationMode(kind == ResamplingKind::Nearest ? VTK_RESLICE_NEAREST
                                                                : VTK_RESLICE_LINEAR);
  reslice->SetBackgroundLevel(kind == ResamplingKind::Nearest ? 0.0 : voxels->GetRange()[0]);
  reslice->Update();
  return reslice->GetOutput()->GetPointData()->GetScalars();
}

vtkSmartPointer<vtkImageData> ResampleSheared(const std::filesystem::path& file,
                                              vtkImageData* sheared, ResamplingKind kind)
{
  const ImageGrid from = GridOf(sheared);
  const ImageGrid to = GridAround(from);
  Eigen::Affine3d steps = Eigen::Affine3d::Identity();
  steps.linear() = StepsOf(to);
  steps.translation() = to.OriginWorld;
  return MakeImage(to, ResampledVoxels(file, sheared, to.Size, IndexMap(from, steps), kind));
}
} // namespace palpate
