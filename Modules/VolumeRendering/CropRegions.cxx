#include "CropRegions.h"

namespace palpate
{
CropRegions::CropRegions(const std::array<double, 6>& planesIndex, int flags)
    : Planes(planesIndex), Flags(flags & All)
{
}

bool CropRegions::Shows(const Vector3& pointIndex) const noexcept
{
  int region = 0;
  int weight = 1;
  for (std::size_t axis = 0; axis < 3; ++axis, weight *= 3)
  {
    const double place = pointIndex[static_cast<Eigen::Index>(axis)];
    const bool isAboveLower = place >= this->Planes[2 * axis];
    const bool isAboveUpper = place > this->Planes[2 * axis + 1];
    region += weight * (static_cast<int>(isAboveLower) + static_cast<int>(isAboveUpper));
  }
  return (this->Flags >> region & 1) != 0;
}

std::vector<HalfSpace> CropRegions::Sides(const FieldGrid& grid) const
{
  std::vector<HalfSpace> sides;
  if (this->Flags != Middle)
  {
    return sides;
  }
  for (int axis = 0; axis < 3; ++axis)
  {
    const Vector3 normal = grid.GradientWorld(Vector3::Unit(axis));
    const double start = normal.dot(grid.OriginWorld());
    sides.push_back({normal, -start - this->Planes[static_cast<std::size_t>(2 * axis)]});
    sides.push_back({-normal, start + this->Planes[static_cast<std::size_t>(2 * axis + 1)]});
  }
  return sides;
}
} // namespace palpate
