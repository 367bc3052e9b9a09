#include "ImageIndexToWorld.h"

#include "vtkImageData.h"
#include "vtkMatrix4x4.h"

namespace palpate
{
IndexToWorld IndexToWorldOf(vtkImageData* image)
{
  const vtkMatrix4x4* matrix = image->GetIndexToPhysicalMatrix();
  IndexToWorld toWorld;
  for (int row = 0; row < 3; ++row)
  {
    toWorld.Origin[row] = matrix->GetElement(row, 3);
    for (int axis = 0; axis < 3; ++axis)
    {
      toWorld.Axes(row, axis) = matrix->GetElement(row, axis);
    }
  }
  const int* extent = image->GetExtent();
  toWorld.Origin += toWorld.Axes * Vector3(extent[0], extent[2], extent[4]);
  return toWorld;
}
} // namespace palpate
