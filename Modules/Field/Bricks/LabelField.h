#pragma once

#include "FieldGrid.h"
#include "FieldSamples.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// One label of a label map as a signed distance in mm, positive inside, whose interpolation has a
/// smooth zero level half way between voxel centres of different kinds, instead of voxel steps.
/// What lies outside the volume is unknown, not empty.
///
/// Where one spacing is at least 1.5 times each of the others, distances run within slices and are
/// cut off at one slice step, as in Surface: interpolated between the slices, they interpolate the
/// outline's shape (Raya and Udupa, "Shape-based interpolation of multidimensional objects", IEEE
/// Transactions on Medical Imaging 9, 1990). Elsewhere they run in space, cut off at four voxels.
///
/// Unsmoothed, the field keeps the side of every voxel centre, and its normals still feel the
/// voxels. Smoothing is a Gaussian whose standard deviation is given in the smallest spacing; what
/// is thinner than that may vanish.
class LabelField
{
public:
  /// `labels` are integers on the whole grid. Refuses a label that no voxel has, and a
  /// smoothing that is negative or wider than 8.
  static Status Make(const FieldSamples& labels, const FieldGrid& grid, long long label,
                     double smoothing, LabelField& field);

  /// For FieldBuilder; the label is where they are at least 0. They live as long as this does.
  FieldSamples Samples() const noexcept;

private:
  std::vector<float> Distances;
  std::array<int, 3> StartIndex{};
  std::array<int, 3> Size{};
  float CutOff = 0.0f;
};
} // namespace palpate
