#include "ImageWithin.h"

#include "FieldOfImage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
// First and last nodes, in the grid.
struct NodeRange
{
  std::array<int, 3> First{};
  std::array<int, 3> Last{};

  bool HasCells() const
  {
    return this->First[0] < this->Last[0] && this->First[1] < this->Last[1] &&
           this->First[2] < this->Last[2];
  }
};

NodeRange RangeOf(const FieldGrid& grid, const Eigen::AlignedBox3d& boxWorld)
{
  Eigen::AlignedBox3d box;
  for (int corner = 0; corner < 8; ++corner)
  {
    const auto type = static_cast<Eigen::AlignedBox3d::CornerType>(corner);
    box.extend(grid.PointIndex(boxWorld.corner(type)));
  }
  NodeRange range;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    // One more than needed, against rounding.
    const double last = grid.Size()[axis] - 1;
    range.First[axis] = static_cast<int>(std::clamp(std::floor(box.min()[a]) - 1.0, 0.0, last));
    range.Last[axis] = static_cast<int>(std::clamp(std::ceil(box.max()[a]) + 1.0, 0.0, last));
  }
  return range;
}
} // namespace

vtkSmartPointer<vtkImageData> ImageWithin(vtkImageData* image, const Eigen::AlignedBox3d& boxWorld)
{
  const FieldGrid grid = GridOfImage(image);
  const NodeRange range = RangeOf(grid, boxWorld);
  if (!range.HasCells())
  {
    return image;
  }
  std::array<int, 3> size{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    size[axis] = range.Last[axis] - range.First[axis] + 1;
  }
  const Vector3 first(range.First[0], range.First[1], range.First[2]);
  vtkSmartPointer<vtkImageData> part =
      EmptyImageOf({size, grid.PointWorld(first), grid.Spacing(), grid.Direction()});
  part->AllocateScalars(image->GetScalarType(), 1);
  const auto* from = static_cast<const char*>(image->GetScalarPointer());
  auto* to = static_cast<char*>(part->GetScalarPointer());
  const auto bytes = static_cast<std::size_t>(image->GetScalarSize());
  const std::size_t row = bytes * static_cast<std::size_t>(size[0]);
  for (int k = range.First[2]; k <= range.Last[2]; ++k)
  {
    for (int j = range.First[1]; j <= range.Last[1]; ++j, to += row)
    {
      const auto node = (static_cast<std::size_t>(k) * static_cast<std::size_t>(grid.Size()[1]) +
                         static_cast<std::size_t>(j)) *
                            static_cast<std::size_t>(grid.Size()[0]) +
                        static_cast<std::size_t>(range.First[0]);
      std::memcpy(to, from + bytes * node, row);
    }
  }
  return part;
}
} // namespace palpate
