#include "MassAround.h"

#include "AxisWeights.h"

#include <algorithm>
#include <array>

namespace palpate
{
ShapeField MassAround(const ShapeGrid& grid, const std::vector<unsigned char>& inside, double width)
{
  constexpr double Deviation = 3.0; // in steps
  const double step = std::max(1.0, width / Deviation);
  ShapeField mass{grid, std::vector<float>(inside.begin(), inside.end())};
  std::array<int, 3> size = grid.Size;
  std::array<double, 3> first{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int count = static_cast<int>((size[axis] - 1) / step) + 1;
    first[axis] = 0.5 * (size[axis] - 1 - (count - 1) * step); // centred, as the grid is
    const AxisWeights weights({size[axis], count, first[axis], step, width / step});
    mass.Values = weights.Apply(mass.Values, size, axis);
  }
  for (std::size_t axis = 0; axis < 3 && size != grid.Size; ++axis)
  {
    const AxisWeights weights({size[axis], grid.Size[axis], -first[axis] / step, 1.0 / step, 0.0});
    mass.Values = weights.Apply(mass.Values, size, axis);
  }
  return mass;
}
} // namespace palpate
