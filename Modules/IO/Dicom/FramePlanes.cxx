#include "FramePlanes.h"

#include "Refusal.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <Eigen/LU>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
Eigen::Matrix3d VoxelSteps(const ImageGrid& grid)
{
  return grid.Direction * grid.Spacing.asDiagonal();
}

// From a voxel index of one grid to that of another one.
Vector3 IndexIn(const ImageGrid& grid, const Vector3& pointWorld)
{
  return VoxelSteps(grid).inverse() * (pointWorld - grid.OriginWorld);
}

Vector3 LastOf(const ImageGrid& grid)
{
  return {grid.Size[0] - 1.0, grid.Size[1] - 1.0, grid.Size[2] - 1.0};
}

// 0 or 1 along each axis, for the eight corners of a grid.
Vector3 CornerShare(int corner)
{
  return {static_cast<double>(corner & 1), static_cast<double>(corner / 2 & 1),
          static_cast<double>(corner / 4)};
}

// The extent of a grid as indices of another one.
std::pair<Vector3, Vector3> BoxIn(const ImageGrid& grid, const ImageGrid& of)
{
  Vector3 least = Vector3::Constant(HUGE_VAL);
  Vector3 most = -least;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 world =
        of.OriginWorld + VoxelSteps(of) * CornerShare(corner).cwiseProduct(LastOf(of));
    const Vector3 index = IndexIn(grid, world);
    least = least.cwiseMin(index);
    most = most.cwiseMax(index);
  }
  return {least, most};
}
// Whether an index of one grid is that of a voxel of another one for every voxel, to a twentieth of
// a voxel, once they are rounded.
bool AreWhole(const Vector3& start, const Eigen::Matrix3d& steps, const Vector3& last)
{
  constexpr double Most = 0.05;
  const Eigen::Matrix3d whole = steps.array().round().matrix();
  const bool isTurned = (whole.cwiseAbs() * Vector3::Ones()).isOnes() &&
                        (whole.cwiseAbs().transpose() * Vector3::Ones()).isOnes();
  double off = 0.0;
  for (int corner = 0; corner < 8; ++corner)
  {
    const Vector3 error = start - Vector3(start.array().round().matrix()) +
                          (steps - whole) * CornerShare(corner).cwiseProduct(last);
    off = std::max(off, error.cwiseAbs().maxCoeff());
  }
  return isTurned && off < Most;
}
} // namespace

FramePlanes::FramePlanes(const ImageGrid& mask, const DicomSource& source, OtherVoxels others)
    : Planes(source.Grid())
{
  const Vector3 last = LastOf(this->Planes);
  const auto [least, most] = BoxIn(this->Planes, mask);
  if ((most.array() < -0.5).any() || ((least - last).array() > 0.5).any())
  {
    Refuse(source.Path(), "is a series that the segmentation lies outside of",
           "specify the series that it was made on");
  }
  this->Start = IndexIn(mask, this->Planes.OriginWorld);
  this->Steps = VoxelSteps(mask).inverse() * VoxelSteps(this->Planes);
  const bool isInside = (least.array() > -0.5).all() && ((most - last).array() < 0.5).all();
  this->Exact = isInside && AreWhole(this->Start, this->Steps, last);
  if (!this->Exact && others == OtherVoxels::KeepOwn)
  {
    this->Planes = mask;
    this->Start.setZero();
    this->Steps.setIdentity();
    return;
  }
  for (const DicomSource::Slice& slice : source.Slices())
  {
    this->Origins.push_back(slice.PositionWorld);
  }
}

Vector3 FramePlanes::OriginWorld(int plane) const
{
  return this->IsOnSeries()
             ? this->Origins[static_cast<std::size_t>(plane)]
             : Vector3(this->Planes.OriginWorld + VoxelSteps(this->Planes) * Vector3(0, 0, plane));
}

void FramePlanes::Read(vtkImageData* layer, int plane, std::vector<int>& values) const
{
  vtkDataArray* voxels = layer->GetPointData()->GetScalars();
  const int* size = layer->GetDimensions();
  values.assign(static_cast<std::size_t>(this->Planes.Size[0]) *
                    static_cast<std::size_t>(this->Planes.Size[1]),
                0);
  std::size_t pixel = 0;
  for (int row = 0; row < this->Planes.Size[1]; ++row)
  {
    const Vector3 first = this->Start + this->Steps * Vector3(0, row, plane);
    for (int column = 0; column < this->Planes.Size[0]; ++column, ++pixel)
    {
      vtkIdType place = 0;
      bool isInside = true;
      for (int axis = 2; axis >= 0; --axis)
      {
        const double index = std::floor(first[axis] + column * this->Steps(axis, 0) + 0.5);
        isInside = isInside && index >= 0.0 && index < size[axis];
        place = place * size[axis] + (isInside ? static_cast<vtkIdType>(index) : 0);
      }
      values[pixel] = isInside ? static_cast<int>(voxels->GetComponent(place, 0)) : 0;
    }
  }
}
} // namespace palpate
