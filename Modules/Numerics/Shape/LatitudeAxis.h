#pragma once

#include "ParametricSphericalSurface.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// The axis of a surface through the middles of the circles of equal parameter latitude, which
/// SPHARM-PDM calls the medial axis: at `Theta` (rad from +z) the mean of the surface points along
/// the circle, their mean distance from it, and the area of the fan of triangles between it and
/// them.
struct LatitudeAxis
{
  std::vector<double> Theta;
  std::vector<Vector3> Middles; ///< mm, in the surface's frame
  std::vector<double> Radii;    ///< mm
  std::vector<double> Areas;    ///< mm^2
};

/// `latitudes` >= 2 from pole to pole, `longitudes` >= 3 points on each. Allocates.
LatitudeAxis FindLatitudeAxis(const ParametricSphericalSurface& surface, int latitudes,
                              int longitudes);
} // namespace palpate
