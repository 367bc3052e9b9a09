#include "OrthogonalResampling.h"

#include "AvailableMemory.h"
#include "ImageGrid.h"

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

// From indices of `to` to continuous indices of `from`.
vtkSmartPointer<vtkMatrix4x4> IndexTransform(const ImageGrid& from, const ImageGrid& to)
{
  const Eigen::Matrix3d inverse = StepsOf(from).inverse();
  Eigen::Matrix<double, 4, 4, Eigen::RowMajor> rows =
      Eigen::Matrix<double, 4, 4, Eigen::RowMajor>::Identity();
  rows.topLeftCorner<3, 3>() = inverse * StepsOf(to);
  rows.topRightCorner<3, 1>() = inverse * (to.OriginWorld - from.OriginWorld);
  auto matrix = vtkSmartPointer<vtkMatrix4x4>::New();
  matrix->DeepCopy(rows.data());
  return matrix;
}
} // namespace

vtkSmartPointer<vtkImageData> ResampleSheared(const std::filesystem::path& file,
                                              vtkImageData* sheared, ResamplingKind kind)
{
  const ImageGrid from = GridOf(sheared);
  const ImageGrid to = GridAround(from);
  vtkDataArray* voxels = sheared->GetPointData()->GetScalars();
  CheckMemory(file, static_cast<double>(to.VoxelCount()) * voxels->GetDataTypeSize());
  // In indices, since VTK 9.1's filter ignores directions.
  vtkNew<vtkImageData> indexed;
  indexed->SetDimensions(from.Size.data());
  indexed->GetPointData()->SetScalars(voxels);
  vtkNew<vtkImageReslice> reslice;
  reslice->SetInputData(indexed);
  reslice->SetResliceAxes(IndexTransform(from, to));
  reslice->SetOutputSpacing(1.0, 1.0, 1.0);
  reslice->SetOutputOrigin(0.0, 0.0, 0.0);
  reslice->SetOutputExtent(0, to.Size[0] - 1, 0, to.Size[1] - 1, 0, to.Size[2] - 1);
  reslice->SetInterpolationMode(kind == ResamplingKind::Nearest ? VTK_RESLICE_NEAREST
                                                                : VTK_RESLICE_LINEAR);
  reslice->SetBackgroundLevel(kind == ResamplingKind::Nearest ? 0.0 : voxels->GetRange()[0]);
  reslice->Update();
  return MakeImage(to, reslice->GetOutput()->GetPointData()->GetScalars());
}
} // namespace palpate
