#pragma once

#include "ParametricShape.h"

#include <array>

namespace palpate
{
/// Bounds that hold at every parameter u of a parametric surface and along every great circle
/// through it, with derivatives of the point x by the circle's angle.
///
/// Along a great circle every component v.x of the point is a trigonometric polynomial of degree L.
/// So is a component of a derivative in directions that are moved in parallel along the circle:
/// with the circle as the equator, these are derivatives by longitude and latitude of a sum of
/// harmonics. If |x'''|, say, is largest at u, for the tangent t, then with v along it v.x''' falls
/// from there, along any great circle, no faster than cos(L s) (M. Riesz 1914). So the largest
/// values at parameters that leave gaps of the angle s bound those everywhere. The surface is
/// evaluated at about 10 L^2 parameters.
struct PointDerivativeBounds
{
  explicit PointDerivativeBounds(const ParametricShape& shape);

  double Largest() const noexcept { return this->Point[0]; } ///< bound of |x|, mm

  std::array<double, 4> Point; ///< |x| from the centre (mm), |x'| (mm/rad), |x''|, |x'''|
  double PointThird;           ///< |x'''|, and the same for three different directions
};
} // namespace palpate
