#include "VoxelMinimum.h"

#include "vtkImageData.h"

#include <cmath>

namespace palpate
{
namespace
{
// A few voxels have no shape: fewer than a cube of two.
constexpr long SmallestVoxelCount = 8;
} // namespace

std::string TooFewVoxels(double cubicMillimeters, vtkImageData* mask)
{
  const double* spacing = mask->GetSpacing();
  const long voxels = std::lround(cubicMillimeters / (spacing[0] * spacing[1] * spacing[2]));
  if (voxels >= SmallestVoxelCount)
  {
    return {};
  }
  return "has only " + std::to_string(voxels) + (voxels == 1 ? " voxel" : " voxels") +
         ", too few to have a shape; choose another --label or --component";
}
} // namespace palpate
