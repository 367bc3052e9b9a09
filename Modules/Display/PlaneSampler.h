#pragma once

#include "ImageAxes.h"
#include "PalpateDisplayModule.h"
#include "PixelGrid.h"

class vtkImageData;

namespace palpate
{
/// Values of an image (its first component) at the pixels of a plane. The image may lie on any
/// grid: only millimetres count. It is neither copied nor kept alive; rows may be sampled by
/// several threads at once.
class PALPATEDISPLAY_EXPORT PlaneSampler
{
public:
  PlaneSampler(vtkImageData* image, const PixelGrid& pixels);

  /// Linearly interpolated; up to half a voxel beyond the outermost centres belongs to the image,
  /// and outside there is no number. `values` has room for a row.
  void SampleLinear(int row, float* values) const;
  /// Of the nearest voxel; `outside` where there is none.
  void SampleNearest(int row, float outside, float* values) const;

private:
  ImageAxes Axes;
  PixelGrid Pixels;
  Vector3 FirstIndex; // of the first pixel, counted from the first voxel
  Vector3 ColumnStep; // in voxels
  Vector3 RowStep;
  int Type;
  int Components;
  const void* Voxels;
};
} // namespace palpate
