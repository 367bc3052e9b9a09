#pragma once

#include "ImageAxes.h"
#include "PalpateDisplayModule.h"
#include "PixelGrid.h"

class vtkImageData;

namespace palpate
{
/// Samples an image (its first component) at the pixels of a plane. The image may have any grid:
/// positions are in mm. It is neither copied nor referenced; several threads may sample rows at
/// once.
class PALPATEDISPLAY_EXPORT PlaneSampler
{
public:
  PlaneSampler(vtkImageData* image, const PixelGrid& pixels);

  /// Linear interpolation; the image extends half a voxel beyond the outermost centres, and values
  /// outside are NaN. `values` must hold a row.
  void SampleLinear(int row, float* values) const;
  /// Nearest voxel; `outside` beyond the image.
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
