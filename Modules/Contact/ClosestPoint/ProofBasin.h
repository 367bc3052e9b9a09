#pragma once

#include "RoundBasin.h"
#include "SphericalTriangle.h"
#include "StretchedBasin.h"

#include <algorithm>

namespace palpate
{
// What a ClearanceProof asks the two kinds of basin around a direction: for a cap inside, for a
// point near, and for a chord beyond which no direction is in it.
inline bool Contains(const RoundBasin& basin, const Vector3& around,
                     const SphericalCap& cap) noexcept
{
  const double margin = basin.Angle - cap.Radius;
  const double chord = (cap.Center - around).norm();
  // An angle is less than this up to 2.6 rad.
  return chord * (1.0 + 0.1 * chord * chord) < margin;
}
inline bool Contains(const StretchedBasin& basin, const Vector3& around,
                     const SphericalCap& cap) noexcept
{
  return basin.Contains(around, cap.Center, cap.Radius);
}
inline bool IsNear(const RoundBasin& basin, const Vector3& around, const Vector3& direction,
                   double reach) noexcept
{
  return (around - direction).norm() < basin.Angle + reach;
}
inline bool IsNear(const StretchedBasin& basin, const Vector3& around, const Vector3& direction,
                   double reach) noexcept
{
  return basin.IsNear(around, direction, reach);
}
inline double WidestChord(const RoundBasin& basin) noexcept
{
  return basin.Angle; // of which it is shorter
}
inline double WidestChord(const StretchedBasin& basin) noexcept
{
  return basin.WidestChord();
}
inline void Widen(RoundBasin& basin, double angle) noexcept
{
  basin.Angle = std::max(basin.Angle, angle);
}
inline void Widen(StretchedBasin& basin, double angle) noexcept
{
  basin.LeastAngle = angle;
}
inline RoundBasin Limited(RoundBasin basin) noexcept
{
  constexpr double Widest = 2.0; // rad
  basin.Angle = std::min(basin.Angle, Widest);
  return basin;
}
inline const StretchedBasin& Limited(const StretchedBasin& basin) noexcept
{
  return basin;
}
} // namespace palpate
