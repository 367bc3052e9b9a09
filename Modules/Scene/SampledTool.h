#pragma once

#include "CutTool.h"
#include "Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace palpate
{
/// Samples a cutting tool within a box (mm, tool frame) from a function that returns a point's
/// signed distance to the tool's surface: about 24 nodes across the thinnest side, at most 160
/// along the longest.
template <typename Distance>
CutTool SampledTool(const Eigen::AlignedBox3d& box, const Distance& distance)
{
  constexpr double NodesOfThinnest = 24.0;
  constexpr double NodesOfLongest = 154.0;
  constexpr int Rim = 3;
  const Vector3 sides = box.sizes();
  const double spacing =
      std::max(sides.minCoeff() / NodesOfThinnest, sides.maxCoeff() / NodesOfLongest);
  std::array<int, 3> size{};
  Vector3 origin;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const auto a = static_cast<Eigen::Index>(axis);
    size[axis] = static_cast<int>(std::ceil(sides[a] / spacing)) + 2 * Rim + 1;
    origin[a] = box.center()[a] - 0.5 * spacing * (size[axis] - 1);
  }
  const FieldGrid grid(size, origin, Vector3::Constant(spacing), Matrix3::Identity());
  std::vector<double> distances;
  distances.reserve(grid.NodeCount());
  for (int k = 0; k < size[2]; ++k)
  {
    for (int j = 0; j < size[1]; ++j)
    {
      for (int i = 0; i < size[0]; ++i)
      {
        distances.push_back(distance(grid.PointWorld(Vector3(i, j, k))));
      }
    }
  }
  return CutTool::Surface(grid, std::move(distances));
}
} // namespace palpate
