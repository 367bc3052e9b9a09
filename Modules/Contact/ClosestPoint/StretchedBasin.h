#pragma once

#include "CenteredSurface.h"
#include "PointDerivativeBounds.h"
#include "Vector3.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace palpate
{
/// Parameters around a closest point of a surface model within which no point is closer than
/// `LowerDistance`. The parameters may be stretched far more in one direction than in the other, so
/// that they are an ellipse: those whose step from the closest point is at most `Reach` mm on the
/// surface, to first order.
struct StretchedBasin
{
  double Reach = 0.0;         ///< mm; 0 if unknown
  double LowerDistance = 0.0; ///< mm
  double LeastAngle = 0.0;    ///< rad; the parameters within it belong to the basin too
  std::array<Vector3, 2> Tangents{Vector3::Zero(), Vector3::Zero()}; ///< of the parameter sphere
  std::array<double, 3> Metric{}; ///< products of x' along them, mm^2/rad^2
  double Stretch = 0.0;           ///< the largest |x'|, mm/rad
  double Least = 0.0;             ///< the smallest

  /// Whether the basin around the parameter `around` contains the cap, all parameters on the unit
  /// sphere.
  bool Contains(const Vector3& around, const Vector3& center, double reach) const noexcept
  {
    const double angle = AngleTo(around, center) + reach;
    return angle < this->LeastAngle ||
           (angle <= WidestAngle && this->FarthestStep(around, center, reach, angle) < this->Reach);
  }
  /// No direction farther than this chord from `around` is contained.
  double WidestChord() const noexcept
  {
    // Steps are at least sin s times Least, and chords at most 1.15 sin s up to 1 rad.
    const double chord = this->Least > 0.0 ? 1.15 * this->Reach / this->Least : 0.0;
    return std::max(this->LeastAngle, chord);
  }
  /// Whether the cap touches the basin, roughly.
  bool IsNear(const Vector3& around, const Vector3& center, double reach) const noexcept
  {
    const double angle = AngleTo(around, center);
    return angle < this->LeastAngle + reach ||
           (angle <= WidestAngle &&
            this->FarthestStep(around, center, 0.0, angle) < this->Reach + this->Stretch * reach);
  }

private:
  static constexpr double WidestAngle = 1.0; // rad

  // An angle is less than this up to 2.6 rad.
  static double AngleTo(const Vector3& around, const Vector3& center) noexcept
  {
    const double chord = (center - around).norm();
    return chord * (1.0 + 0.1 * chord * chord);
  }
  // A step along a great circle of the angle s has a tangent part of sin s, and steps are at most s
  // / sin s times as far apart as their ends. Up to 1 rad that is below 1 + 0.2 s^2.
  double FarthestStep(const Vector3& around, const Vector3& center, double reach,
                      double angle) const noexcept
  {
    const Vector3 across = center - center.dot(around) * around;
    const double a = across.dot(this->Tangents[0]);
    const double b = across.dot(this->Tangents[1]);
    const double square =
        this->Metric[0] * a * a + 2.0 * this->Metric[1] * a * b + this->Metric[2] * b * b;
    return (std::sqrt(std::max(0.0, square)) + this->Stretch * reach) * (1.0 + 0.2 * angle * angle);
  }
};

/// The basin around a minimum of the distance, from the sample there. `offset` (mm) is from the
/// point of the sample to the query, `rounding` (mm) that of distances. Without one if the distance
/// is not convex at the sample.
StretchedBasin StretchedBasinAround(const Vector3& parameter,
                                    const CenteredSurface::SecondOrderSample& sample,
                                    const Vector3& offset, const PointDerivativeBounds& bounds,
                                    double rounding) noexcept;
} // namespace palpate
