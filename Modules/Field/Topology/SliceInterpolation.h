#pragma once

#include "AxisWeights.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Shape-based interpolation between thick slices (Raya and Udupa, "Shape-based interpolation of
/// multidimensional objects", IEEE TMI 9, 1990), curved as the object is: from signed distances
/// within slices to those at nodes along the slices' axis.
///
/// Where the wall is near in the slices around, compared with the object's depth: a polynomial of
/// degree 5 through six slices, which follows an oblique wall and bumps on it (of a cosine's peak
/// 20 mm wide, on a wall at 45 degrees to slices of 3 mm, 1 % is lost half way between slices; by
/// cubics 3 %). Elsewhere, as next to ends: a cubic of bounded distances, since far ones say
/// nothing of the wall. One passes into the other.
class SliceInterpolation
{
public:
  /// Slices across an axis, and nodes along it.
  SliceInterpolation(std::size_t across, const AxisNodes& nodes);

  /// `distances` (mm, i fastest; finite) are of `size`, which is updated. Where a cubic is used
  /// they are bounded by `bound` (mm), but by no more than a third of the object's depth.
  std::vector<float> Apply(const std::vector<float>& distances, double bound,
                           std::array<int, 3>& size) const;

private:
  std::vector<float> Sampled(const std::vector<float>& values, AxisWeights::Interpolation between,
                             std::array<int, 3>& size) const;
  std::vector<float> SharesNearWall(const std::vector<float>& distances, double depth,
                                    const std::array<int, 3>& size) const;

  std::size_t Across;
  AxisNodes Nodes;
};
} // namespace palpate
