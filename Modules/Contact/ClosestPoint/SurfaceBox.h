#pragma once

#include "CenteredSurface.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
/// The same as SurfacePatch for a surface model: a box along the normal and the direction in
/// which the parameters are stretched most, since they may be stretched far more in one direction
/// than in the other. Points are relative to the surface's centre, mm.
struct SurfaceBox
{
  SurfaceBox() = default;
  /// For the cap of the angle `reach` (rad) around the sample's parameter; `pointThird` bounds
  /// |x'''| (PointDerivativeBounds).
  SurfaceBox(const Vector3& parameter, const CenteredSurface::SecondOrderSample& sample,
             double reach, double pointThird) noexcept;

  /// Lower bound (mm) of the distance from the query to the part, up to rounding.
  double LowerDistance(const Vector3& query) const noexcept
  {
    const Vector3 place = this->Axes.transpose() * (query - this->Point);
    return (this->Low - place).cwiseMax(place - this->High).cwiseMax(0.0).norm();
  }
  Vector3 Center() const noexcept
  {
    return this->Point + this->Axes * (0.5 * (this->Low + this->High));
  }
  /// Of a sphere around the centre.
  double Extent() const noexcept { return 0.5 * (this->High - this->Low).norm(); }

  Vector3 Point;
  Matrix3 Axes; ///< columns: two unit tangents and the normal
  Vector3 Low;  ///< smallest and largest coordinates along the axes, from Point
  Vector3 High;
};
} // namespace palpate
