#pragma once

#include "PalpateVolumeRenderingModule.h"
#include "RayCaster.h"

#include <vector>

namespace palpate
{
/// The points x (mm) with Normal . x + Offset >= 0: what a clipping plane leaves.
struct HalfSpace
{
  Vector3 Normal = Vector3::UnitX();
  double Offset = 0.0;
};

/// What all half-spaces leave of an interval.
PALPATEVOLUMERENDERING_EXPORT RayInterval ClippedInterval(const FieldRay& ray,
                                                          const std::vector<HalfSpace>& kept,
                                                          RayInterval interval) noexcept;
} // namespace palpate
