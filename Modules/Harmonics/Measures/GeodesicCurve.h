#pragma once

#include "SurfaceModel.h"
#include "Vector3.h"

#include <vector>

namespace palpate
{
/// A curve on a surface model that no small change shortens.
struct GeodesicCurve
{
  std::vector<Vector3> Parameters; ///< unit vectors, from end to end
  std::vector<Vector3> Points;     ///< of the surface, mm, at equal distances
  double Length = 0.0;             ///< mm
  double Uncertainty = 0.0;  ///< mm, by which the length may be wrong: between two resolutions
  bool HasConverged = false; ///< the uncertainty is below 1e-6 of the length
};

/// Straightens a curve, at least two unit vectors of parameters, between its ends: Newton's method
/// (Gauss-Newton where the curve can still become much shorter) for the least sum of squared
/// chords, whose minimum has chords of equal length along a geodesic. The length is extrapolated
/// from chords (Richardson), which are doubled until it stays. Another start may give another
/// geodesic.
///
/// A parameter where the surface has no tangent plane does not move well. Allocates; about 1 ms.
GeodesicCurve Straightened(const SurfaceModel& surface, const std::vector<Vector3>& start);
} // namespace palpate
