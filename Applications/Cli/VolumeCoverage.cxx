#include "VolumeCoverage.h"

#include "vtkImageData.h"

#include <cmath>

namespace palpate::cli
{
namespace
{
constexpr int Steps = 24; // points of the box along each axis

bool IsInVoxels(vtkImageData* image, const double* pointWorld)
{
  double index[3];
  image->TransformPhysicalPointToContinuousIndex(pointWorld, index);
  const int* extent = image->GetExtent();
  for (int axis = 0; axis < 3; ++axis)
  {
    if (index[axis] < extent[2 * axis] - 0.5 || index[axis] > extent[2 * axis + 1] + 0.5)
    {
      return false;
    }
  }
  return true;
}
} // namespace

double CoveredPercent(vtkImageData* image, const double* boundsWorld)
{
  int covered = 0;
  for (int i = 0; i < Steps * Steps * Steps; ++i)
  {
    const int steps[3] = {i % Steps, i / Steps % Steps, i / (Steps * Steps)};
    double point[3];
    for (int axis = 0; axis < 3; ++axis)
    {
      const double low = boundsWorld[2 * axis];
      const double high = boundsWorld[2 * axis + 1];
      point[axis] = low + (high - low) * (steps[axis] + 0.5) / Steps;
    }
    covered += IsInVoxels(image, point) ? 1 : 0;
  }
  return 100.0 * covered / (Steps * Steps * Steps);
}

std::string CoverageNote(vtkImageData* image, const double* boundsWorld)
{
  const double percent = CoveredPercent(image, boundsWorld);
  if (percent >= 100.0)
  {
    return {};
  }
  return "the volume covers only " + std::to_string(static_cast<int>(std::floor(percent))) +
         " % of the structure's box; check that it belongs to the mask";
}
} // namespace palpate::cli
