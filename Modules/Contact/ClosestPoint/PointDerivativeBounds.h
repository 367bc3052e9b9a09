#pragma once

#include "CapMaxima.h"
#include "CenteredSurface.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace palpate
{
/// Bounds that hold at every parameter u of a surface model and along every great circle
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
  explicit PointDerivativeBounds(const CenteredSurface& shape);

  double Largest() const noexcept { return this->Point[0]; } ///< bound of |x|, mm
  /// The same as PointThird in the cap of the angle (rad) around a unit vector of parameters.
  double ThirdWithin(const Vector3& parameter, double angle) const noexcept
  {
    return std::min(this->PointThird,
                    this->Thirds.Within(parameter, angle) + (this->Between + this->Point[1]));
  }
  /// Wider caps have another bound.
  const CapMaxima::Angles& CapAngles() const noexcept { return this->Thirds.AngleList(); }
  std::size_t Bytes() const noexcept { return this->Thirds.Bytes(); }

  std::array<double, 4> Point; ///< |x| from the centre (mm), |x'| (mm/rad), |x''|, |x'''|
  double PointThird;           ///< |x'''|, and the same for three different directions

private:
  CapMaxima Thirds;
  double Between; // by how much |x'''| may be above the largest at the corners of a triangle
};
} // namespace palpate
