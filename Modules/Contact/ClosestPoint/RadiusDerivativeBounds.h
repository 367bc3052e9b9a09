#pragma once

#include "RadialModel.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Bounds that hold at every direction u and along every great circle through it, with derivatives
/// by the arc's angle: of the radius R, and of the surface point x = R u.
///
/// Along a great circle a radius of degree L is a trigonometric polynomial of degree L. If its
/// largest size is M, an angle s away it is still at least M cos(L s) (M. Riesz 1914), and its
/// derivative is at most L M (Bernstein 1912). The same holds for its derivatives. So values and
/// first two derivatives at directions that leave gaps of the angle s bound those everywhere, and
/// the second derivative bounds the third. The model is evaluated in about 10 L^2 directions.
struct RadiusDerivativeBounds
{
  explicit RadiusDerivativeBounds(const RadialModel& model);

  double Largest() const noexcept { return this->Radius[0]; } ///< bound of |x| from the centre, mm
  static constexpr std::size_t Bytes() noexcept { return 0; }
  /// Bound of PointThird in a cap of directions.
  double ThirdWithin(const Vector3&, double) const noexcept { return this->PointThird; }

  std::array<double, 4> Radius; ///< |R| (mm), |R'| (mm/rad), |R''|, |R'''|
  double PointThird;            ///< |x'''| (mm/rad^3), and the same for three different directions
};
} // namespace palpate
