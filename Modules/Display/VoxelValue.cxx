#include "VoxelValue.h"

#include "ImageAxes.h"

#include "vtkImageData.h"

#include <cmath>

namespace palpate
{
std::optional<double> VoxelValueAt(vtkImageData* image, const Vector3& pointWorld)
{
  const ImageAxes axes(image);
  const Vector3 index = axes.ToIndex(pointWorld);
  int voxel[3];
  for (int a = 0; a < 3; ++a)
  {
    const double nearest = std::floor(index[a] + 0.5);
    const auto side = static_cast<std::size_t>(2 * a);
    // Written so that NaN counts as outside.
    if (!(nearest >= axes.Extent[side] && nearest <= axes.Extent[side + 1]))
    {
      return std::nullopt;
    }
    voxel[a] = static_cast<int>(nearest);
  }
  return image->GetScalarComponentAsDouble(voxel[0], voxel[1], voxel[2], 0);
}
} // namespace palpate
