#pragma once

#include "ImageGrid.h"
#include "SyntheticImages.h"
#include "TemporaryFolder.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <cmath>
#include <functional>

namespace palpate::test
{
/// A series of 5 slices of 9 x 7 pixels of 2 x 1.5 mm, 3 mm apart, in a folder, and label maps on
/// its voxels.
class SourceSeries
{
public:
  /// `axes`: columns along a row, down a column, and from slice to slice.
  SourceSeries(const std::filesystem::path& folder, const Eigen::Matrix3d& axes)
  {
    this->Grid.Size = {9, 7, 5};
    this->Grid.Spacing = {2.0, 1.5, 3.0};
    this->Grid.OriginWorld = {10.5, -20.25, 30.125};
    this->Grid.Direction = axes;
    std::filesystem::create_directory(folder);
    for (int i = 0; i < this->Grid.Size[2]; ++i)
    {
      DicomSliceSpec slice;
      slice.RowWorld = axes.col(0);
      slice.ColumnWorld = axes.col(1);
      slice.PositionWorld = this->Grid.OriginWorld + 3.0 * i * axes.col(2);
      slice.Columns = this->Grid.Size[0];
      slice.Rows = this->Grid.Size[1];
      slice.Value = static_cast<std::uint16_t>(i + 1);
      WriteDicomSlice(folder / ("slice" + std::to_string(i) + ".dcm"), slice);
    }
  }

  Vector3 PositionOf(int i, int j, int k) const
  {
    return this->Grid.OriginWorld +
           this->Grid.Direction * this->Grid.Spacing.cwiseProduct(Vector3(i, j, k));
  }

  /// Labels from a voxel's indices, stored along axes of which `order` has the columns: signed unit
  /// vectors in the series' axes, right-handed together.
  vtkSmartPointer<vtkImageData> Labels(const std::function<int(int i, int j, int k)>& label,
                                       const Eigen::Matrix3d& order) const
  {
    ImageGrid stored;
    Vector3 first = Vector3::Zero(); // of the series' indices
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      Eigen::Index of = 0;
      order.col(axis).cwiseAbs().maxCoeff(&of);
      stored.Size[static_cast<std::size_t>(axis)] = this->Grid.Size[static_cast<std::size_t>(of)];
      stored.Spacing[axis] = this->Grid.Spacing[of];
      first[of] = order(of, axis) < 0 ? this->Grid.Size[static_cast<std::size_t>(of)] - 1 : 0;
    }
    stored.Direction = this->Grid.Direction * order;
    stored.OriginWorld = this->PositionOf(static_cast<int>(first[0]), static_cast<int>(first[1]),
                                          static_cast<int>(first[2]));
    auto voxels =
        vtkSmartPointer<vtkDataArray>::Take(vtkDataArray::CreateDataArray(VTK_UNSIGNED_CHAR));
    voxels->SetNumberOfTuples(stored.VoxelCount());
    vtkIdType place = 0;
    for (int c = 0; c < stored.Size[2]; ++c)
    {
      for (int b = 0; b < stored.Size[1]; ++b)
      {
        for (int a = 0; a < stored.Size[0]; ++a)
        {
          const Vector3 index = first + order * Vector3(a, b, c);
          voxels->SetComponent(place++, 0,
                               label(static_cast<int>(index[0]), static_cast<int>(index[1]),
                                     static_cast<int>(index[2])));
        }
      }
    }
    return MakeImage(stored, voxels);
  }

  ImageGrid Grid;
};

/// The value of the voxel at a position, which must be a voxel's centre to a hundredth of it; 0
/// outside of the image.
inline int ValueAt(vtkImageData* image, const Vector3& world)
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(world.data(), index);
  int voxel[3];
  for (int k = 0; k < 3; ++k)
  {
    voxel[k] = static_cast<int>(std::lround(index[k]));
    if (!(std::abs(index[k] - voxel[k]) < 0.01))
    {
      return -1;
    }
    if (voxel[k] < 0 || voxel[k] >= image->GetDimensions()[k])
    {
      return 0;
    }
  }
  return static_cast<int>(image->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0));
}

/// The 24 right-handed orders of axes.
inline std::vector<Eigen::Matrix3d> RightHandedOrders()
{
  std::vector<Eigen::Matrix3d> orders;
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity();
  for (int a = 0; a < 6; ++a)
  {
    for (int b = 0; b < 6; ++b)
    {
      const Vector3 first = (a < 3 ? 1.0 : -1.0) * unit.col(a % 3);
      const Vector3 second = (b < 3 ? 1.0 : -1.0) * unit.col(b % 3);
      if (a % 3 != b % 3)
      {
        orders.emplace_back();
        orders.back() << first, second, first.cross(second);
      }
    }
  }
  return orders;
}
} // namespace palpate::test
