#pragma once

#include "Vector3.h"

#include <algorithm>

namespace palpate
{
/// The soft shadow of a spherical tool on surfaces under a sky of even light: the share of that
/// light that the sphere keeps from a surface point.
struct ToolShadow
{
  Vector3 CenterWorld = Vector3::Zero(); ///< mm
  double Radius = 0.0;                   ///< mm; 0: no shadow

  bool IsSeen() const noexcept { return this->Radius > 0.0; }
  /// 0..1: cos(a) (r/d)^2, the form factor of a sphere at distance d and angle a from the normal.
  /// Exact while the sphere is above the point's horizon; a little too small where it crosses it.
  double ShareAt(const Vector3& pointWorld, const Vector3& unitNormalWorld) const noexcept
  {
    const Vector3 path = this->CenterWorld - pointWorld;
    const double distance = std::max(path.norm(), this->Radius);
    const double cosine = std::clamp(unitNormalWorld.dot(path) / distance, 0.0, 1.0);
    return cosine * this->Radius * this->Radius / (distance * distance);
  }
};
} // namespace palpate
