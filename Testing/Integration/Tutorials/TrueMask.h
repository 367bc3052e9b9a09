#pragma once

#include "ImageIndexToWorld.h"
#include "Segmentation.h"

#include "vtkDataArray.h"
#include "vtkPointData.h"

#include <Eigen/LU>
#include <array>
#include <cmath>

namespace palpate::test
{
/// The mask that a tutorial's user would see in the volume.
struct TrueMask
{
  Segmentation Truth;

  /// Where it ends, on the line from a place inside towards another.
  Vector3 EdgeFrom(const Vector3& inside, const Vector3& towards) const
  {
    const Vector3 out = (towards - inside).normalized();
    vtkImageData* mask = this->Truth.Layers[0];
    const IndexToWorld toWorld = IndexToWorldOf(mask);
    const int* size = mask->GetDimensions();
    Vector3 edge = inside;
    for (double r = 0.0; r < 60.0; r += 0.1)
    {
      const Vector3 index = toWorld.Axes.inverse() * (inside + r * out - toWorld.Origin);
      const std::array<int, 3> voxel{{static_cast<int>(std::lround(index.x())),
                                      static_cast<int>(std::lround(index.y())),
                                      static_cast<int>(std::lround(index.z()))}};
      const bool isInside = voxel[0] >= 0 && voxel[0] < size[0] && voxel[1] >= 0 &&
                            voxel[1] < size[1] && voxel[2] >= 0 && voxel[2] < size[2] &&
                            mask->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0) > 0.0;
      edge = isInside ? inside + r * out : edge;
    }
    return edge;
  }
  /// Of a mask on the same grid.
  double DiceOf(vtkImageData* mask) const
  {
    double both = 0.0;
    double sum = 0.0;
    for (vtkIdType n = 0; n < mask->GetNumberOfPoints(); ++n)
    {
      const bool one = mask->GetPointData()->GetScalars()->GetTuple1(n) > 0.0;
      const bool other = this->Truth.Layers[0]->GetPointData()->GetScalars()->GetTuple1(n) > 0.0;
      both += one && other ? 2.0 : 0.0;
      sum += (one ? 1.0 : 0.0) + (other ? 1.0 : 0.0);
    }
    return both / sum;
  }
};
} // namespace palpate::test
