#pragma once

#include "FieldGrid.h"
#include "FieldSamples.h"
#include "Status.h"

#include <vector>

namespace palpate
{
/// One label of a label map as a signed distance in mm, positive inside, whose interpolation has a
/// smooth zero level half way between centres of voxels inside and outside, instead of voxel steps.
/// Outside the volume the label is unknown, not absent.
///
/// If one spacing is at least 1.5 times each of the others, distances are measured within slices
/// and clamped to one slice step, as in Shape: interpolation between the slices then interpolates
/// the outline's shape (Raya and Udupa, "Shape-based interpolation of multidimensional objects",
/// IEEE Transactions on Medical Imaging 9, 1990). Otherwise they are three-dimensional, clamped to
/// four voxels.
///
/// Unsmoothed, the field keeps the side of every voxel centre, and its normals still show the
/// voxels. Smoothing is a Gaussian whose standard deviation is in units of the smallest spacing;
/// thinner parts may vanish. If more than half of the label's voxels would, as of a plate of one
/// voxel, the smoothing is halved until they stay.
class LabelField
{
public:
  /// `labels` are integers on the whole grid. Fails for a label without voxels, and for a smoothing
  /// that is negative or wider than 8.
  static Status Make(const FieldSamples& labels, const FieldGrid& grid, long long label,
                     double smoothing, LabelField& field);

  /// The smoothing that was used.
  double Smoothing() const noexcept { return this->Smoothed; }
  /// For FieldBuilder; the label is where they are at least 0. Valid as long as this object.
  FieldSamples Samples() const noexcept;

private:
  std::vector<float> Distances;
  std::array<int, 3> StartIndex{};
  std::array<int, 3> Size{};
  float CutOff = 0.0f;
  double Smoothed = 0.0;
};
} // namespace palpate
