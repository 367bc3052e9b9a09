#pragma once

#include "AxisWeights.h"

#include <array>
#include <cstddef>
#include <vector>

namespace palpate
{
/// Shape-based interpolation between thick slices (Raya and Udupa, "Shape-based interpolation of
/// multidimensional objects", IEEE TMI 9, 1990), curved as the object is: signed distances within
/// slices, resampled within slices first, then between them.
///
/// Where distances change smoothly over the slices around: a polynomial of degree 5 through six
/// slices, which follows an oblique wall and bumps on it. Elsewhere, as at ledges, next to the
/// object's ends and in small objects: a cubic of bounded distances, since far ones say nothing of
/// the wall and polynomials overshoot. One passes into the other.
class SliceInterpolation
{
public:
  /// `distances` (mm, i fastest, some of them positive, minus infinity in slices without the
  /// object) are of voxels of `size`, in slices across an axis. Where a cubic is used they are
  /// bounded by `bound` (mm, positive), but by no more than a third of the object's depth.
  SliceInterpolation(const std::vector<float>& distances, const std::array<int, 3>& size,
                     std::size_t across, double bound);

  /// Along an axis of the slices.
  void Resample(const AxisWeights& weights, std::size_t axis);
  /// At nodes along the slices' axis.
  std::vector<float> Between(const AxisNodes& nodes) const;

private:
  std::vector<float> SharesOfSmooth(double bound) const;
  std::vector<float> PartBetween(const AxisNodes& nodes) const;
  std::size_t Stride() const noexcept;

  std::array<int, 3> Size;
  std::size_t Across;
  std::vector<float> Near; // bounded, for cubics
  // The polynomials' distances, and their shares (0 to 1); both empty where there are none.
  std::vector<float> Distances;
  std::vector<float> IsSmooth;
};
} // namespace palpate
