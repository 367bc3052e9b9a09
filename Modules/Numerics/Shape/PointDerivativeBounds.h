#pragma once

#include "ParametricShape.h"

#include <array>

namespace palpate
{
/// The same as RadiusDerivativeBounds for the points of a parametric surface.
///
/// Along a great circle every component v.x of the point is a trigonometric polynomial of degree L,
/// and so is a component of the first or second derivative in a direction that is moved in parallel
/// along the circle: with the circle as the equator, derivatives by longitude and latitude of a sum
/// of harmonics. So the inequalities of Riesz and Bernstein hold for the lengths of x, x' and x'':
/// they are those of the component along the largest one.
struct PointDerivativeBounds
{
  explicit PointDerivativeBounds(const ParametricShape& shape);

  double Largest() const noexcept { return this->Point[0]; } ///< bound of |x|, mm

  std::array<double, 3> Point; ///< |x| from the centre (mm), |x'| (mm/rad), |x''|
  double PointThird;           ///< |x'''| (mm/rad^3), and the same for three different directions
};

} // namespace palpate
