#pragma once

#include "AxisWeights.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Shape-based interpolation between thick slices (Raya and Udupa, "Shape-based interpolation of
/// multidimensional objects", IEEE TMI 9, 1990): from signed distances within slices, bounded, to
/// those at nodes along the slices' axis.
class SliceInterpolation
{
public:
  /// Slices across an axis, and nodes along it.
  SliceInterpolation(std::size_t across, const AxisNodes& nodes);

  /// Linear between slices. `distances` (mm, i fastest) are of `size`, which is updated; `bound` is
  /// in mm.
  std::vector<float> Linear(std::vector<float> distances, double bound,
                            std::array<int, 3>& size) const;

  /// Curved as the object is. Where the wall is near in the slices around, compared with the
  /// object's depth: a polynomial of degree 5 through six slices, without a bound, which follows an
  /// oblique wall and bumps on it (of a cosine's peak 20 mm wide, on a wall at 45 degrees to slices
  /// of 3 mm, 1 % is lost half way between slices; by cubics 3 %). Elsewhere, as next to ends:
  /// cubic and `bound`, but no more than a third of the depth, since far distances say nothing of
  /// the wall. One passes into the other.
  std::vector<float> Curved(const std::vector<float>& distances, double bound,
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
