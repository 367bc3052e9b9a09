#pragma once

#include "OrganModel.h"
#include "SurfaceCorrection.h"

namespace palpate
{
/// A model's surface, ready to be pulled: points at the directions of an icosahedron of this
/// frequency. Those of a radial model move along their rays from its centre, so that it stays
/// radial; those of a surface model as they are pulled. Allocates.
SurfaceCorrection StartOfModel(const OrganModel& start, int frequency);

/// The model with its surface moved as the pulls say, projected on the degree of the start, but on
/// no less than `LeastDegree`: what that leaves out of a pull grows as widths shrink, and is below
/// 0.1 mm for widths of a fifth of the organ's radius. `start` is that of StartOfModel. Fails if
/// the surface of a radial model would be pushed to its centre. Allocates.
struct ModelCorrection
{
  static constexpr int LeastDegree = 20;
  static Status Apply(const OrganModel& start, const SurfaceCorrection& correction,
                      OrganModel& corrected);
};
} // namespace palpate
