#include "FslSpace.h"

#include <Eigen/LU>

namespace palpate
{
Eigen::Affine3d FslSpaceOf(const ImageGrid& grid)
{
  Eigen::Affine3d map = Eigen::Affine3d::Identity();
  map.linear() = grid.Direction;
  map.translation() = grid.OriginWorld;
  if (grid.Direction.determinant() > 0.0)
  {
    map.translation() += (grid.Size[0] - 1) * grid.Spacing[0] * grid.Direction.col(0);
    map.linear().col(0) = -grid.Direction.col(0);
  }
  return map;
}
} // namespace palpate
