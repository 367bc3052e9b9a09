#include "LabelsOnGrid.h"

#include "FieldOfImage.h"

#include "vtkDataArray.h"
#include "vtkImageData.h"
#include "vtkPointData.h"
#include "vtkSMPTools.h"

#include <cmath>

namespace palpate
{
namespace
{
// Affine map of node indices from one grid to another.
struct IndexMap
{
  Vector3 First;
  Matrix3 Steps; // columns: one node along i, j, k

  IndexMap(const FieldGrid& from, const FieldGrid& to)
      : First(to.PointIndex(from.PointWorld(Vector3::Zero())))
  {
    for (Eigen::Index axis = 0; axis < 3; ++axis)
    {
      this->Steps.col(axis) = to.VectorIndex(from.VectorWorld(Vector3::Unit(axis)));
    }
  }
  Vector3 operator()(int i, int j, int k) const
  {
    return this->First + this->Steps * Vector3(i, j, k);
  }

  // Whether every node is displaced by less than a thousandth of a voxel.
  bool IsIdentity(const std::array<int, 3>& size) const
  {
    constexpr double Tolerance = 1e-3;
    const Vector3 last(size[0] - 1, size[1] - 1, size[2] - 1);
    const Matrix3 drift = (this->Steps - Matrix3::Identity()) * last.asDiagonal();
    return this->First.cwiseAbs().maxCoeff() + drift.cwiseAbs().rowwise().sum().maxCoeff() <
           Tolerance;
  }
};

// Number of the voxel nearest to an index, or -1 outside of the grid.
vtkIdType NearestVoxel(const Vector3& index, const std::array<int, 3>& size)
{
  vtkIdType number = 0;
  for (int axis = 2; axis >= 0; --axis)
  {
    const auto nodes = size[static_cast<std::size_t>(axis)];
    const double nearest = std::floor(index[axis] + 0.5);
    if (!(nearest >= 0.0 && nearest < nodes))
    {
      return -1;
    }
    number = number * nodes + static_cast<vtkIdType>(nearest);
  }
  return number;
}
} // namespace

vtkSmartPointer<vtkImageData> LabelsOnGrid(vtkImageData* labels, vtkImageData* image)
{
  const FieldGrid from = GridOfImage(image);
  const FieldGrid to = GridOfImage(labels);
  const IndexMap map(from, to);
  if (from.Size() == to.Size() && map.IsIdentity(from.Size()))
  {
    return labels;
  }
  vtkSmartPointer<vtkImageData> matched = EmptyImageOf(from);
  matched->AllocateScalars(labels->GetScalarType(), 1);
  vtkDataArray* source = labels->GetPointData()->GetScalars();
  vtkDataArray* target = matched->GetPointData()->GetScalars();
  const std::array<int, 3> size = from.Size();
  const auto matchSlices = [&](vtkIdType first, vtkIdType last)
  {
    vtkIdType node = first * size[1] * size[0];
    for (auto k = static_cast<int>(first); k < last; ++k)
    {
      for (int j = 0; j < size[1]; ++j)
      {
        for (int i = 0; i < size[0]; ++i)
        {
          const vtkIdType voxel = NearestVoxel(map(i, j, k), to.Size());
          target->SetComponent(node++, 0, voxel < 0 ? 0.0 : source->GetComponent(voxel, 0));
        }
      }
    }
  };
  vtkSMPTools::For(0, size[2], matchSlices);
  return matched;
}
} // namespace palpate
