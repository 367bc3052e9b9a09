#pragma once

#include "RadialModel.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
/// A cylinder guaranteed to contain the part of a model's surface over a cap of directions. It lies
/// along the normal, and its height shrinks with the square of the cap, so it gives a tight lower
/// bound of the distance. Points are relative to the model's centre, mm.
///
/// Along each great circle x(s) = x + s x' + s^2 x'' / 2 up to s^3 |x'''| / 6, x' is tangent, and
/// the normal part of x'' is the second fundamental form.
struct SurfacePatch
{
  SurfacePatch() = default;
  /// For the cap of the angle `reach` (rad) around the unit vector `direction`; `pointThird` bounds
  /// |x'''| (RadiusDerivativeBounds).
  SurfacePatch(const Vector3& direction, const RadialModel::SecondOrderSample& sample, double reach,
               double pointThird) noexcept;

  /// Lower bound (mm) of the distance from the query to the patch, up to rounding.
  double LowerDistance(const Vector3& query) const noexcept
  {
    const Vector3 offset = query - this->Point;
    const double height = offset.dot(this->Normal);
    const double square = std::max(0.0, offset.squaredNorm() - height * height);
    const double above = std::max({0.0, height - this->High, this->Low - height});
    const double lateral = std::max(0.0, std::sqrt(square) - this->Radius);
    return std::sqrt(above * above + lateral * lateral);
  }

  Vector3 Center() const noexcept
  {
    return this->Point + 0.5 * (this->High + this->Low) * this->Normal;
  }
  /// Of a sphere around the centre.
  double Extent() const noexcept
  {
    return std::hypot(this->Radius, 0.5 * (this->High - this->Low));
  }

  Vector3 Point;
  Vector3 Normal;
  double Low; ///< smallest and largest height over Point along Normal, mm
  double High;
  double Radius; ///< mm
};
} // namespace palpate
