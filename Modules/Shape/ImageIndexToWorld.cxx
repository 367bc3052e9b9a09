#include "ImageIndexToWorld.h"

#include "vtkImageData.h"

namespace palpate
{
IndexToWorld IndexToWorldOf(vtkImageData* image)
{
  const auto at = [image](double i, double j, double k)
  {
    const int* extent = image->GetExtent();
    const Vector3 index(i + extent[0], j + extent[2], k + extent[4]);
    Vector3 world;
    image->TransformContinuousIndexToPhysicalPoint(index.data(), world.data());
    return world;
  };
  IndexToWorld toWorld;
  toWorld.Origin = at(0.0, 0.0, 0.0);
  toWorld.Axes.col(0) = at(1.0, 0.0, 0.0) - toWorld.Origin;
  toWorld.Axes.col(1) = at(0.0, 1.0, 0.0) - toWorld.Origin;
  toWorld.Axes.col(2) = at(0.0, 0.0, 1.0) - toWorld.Origin;
  return toWorld;
}
} // namespace palpate
