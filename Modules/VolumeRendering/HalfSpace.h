#pragma once

#include "PalpateVolumeRenderingModule.h"
#include "RayCaster.h"

#include <vector>

namespace palpate
{
/// The points x (mm) with Normal . x + Offset >= 0: the kept side of a clipping plane.
struct HalfSpace
{
  Vector3 Normal = Vector3::UnitX();
  double Offset = 0.0;
};

/// Clips an interval of a ray against all half-spaces.
PALPATEVOLUMERENDERING_EXPORT RayInterval ClippedInterval(const FieldRay& ray,
                                                          const std::vector<HalfSpace>& kept,
                                                          RayInterval interval) noexcept;
} // namespace palpate
