#pragma once

#include "CenteredSurface.h"
#include "CenteredSurfaceSample.h"
#include "RadialModel.h"
#include "SquaredDistance.h"
#include "Vector3.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
// What the descent to a closest point needs to know about the surface at one sample, for each kind
// of surface. Inline: every servo tick passes here.

// Moves a unit vector along a tangent. Short steps, such as every step of a servo tick, need
// neither square root nor division.
inline Vector3 Moved(const Vector3& direction, const Vector3& step) noexcept
{
  const Vector3 end = direction + step;
  const double excess = end.squaredNorm() - 1.0;
  // The next term of the series is below rounding.
  const double scale = std::abs(excess) < 1e-5 ? 1.0 - excess * (0.5 - 0.375 * excess)
                                               : 1.0 / std::sqrt(1.0 + excess);
  return scale * end;
}

/// A size of the surface at the sample, mm/rad.
inline double ScaleOf(const RadialModel::SecondOrderSample& sample) noexcept
{
  return sample.Radius;
}
inline double ScaleOf(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return std::sqrt(0.5 * (sample.First[0].squaredNorm() + sample.First[1].squaredNorm()));
}

/// At least |x'|^2 in every direction, mm^2/rad^2.
inline double SquaredStretch(const RadialModel::SecondOrderSample& sample) noexcept
{
  return sample.Radius * sample.Radius + sample.SurfaceGradient.squaredNorm();
}
inline double SquaredStretch(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return sample.First[0].squaredNorm() + sample.First[1].squaredNorm();
}

/// Lengths at a sample.
struct SampleSizes
{
  double First;    ///< at least |x'| in every direction, mm/rad
  double Second;   ///< at least |x''| in every direction, mm/rad^2
  double Product;  ///< at least 3 |x'.x''| in every direction, mm^2/rad^3
  double Spread;   ///< root of SquaredSpread
  double Distance; ///< |x - q|, mm
  double Gradient; ///< of the squared distance's half, mm^2/rad
};
inline SampleSizes SizesOf(const RadialModel::SecondOrderSample& sample,
                           const SquaredDistance& distance) noexcept
{
  // Square roots are slow, and two take no longer than one.
  using Pair = Eigen::Array2d;
  const double slope = sample.SurfaceGradient.squaredNorm();
  const Pair sizes =
      Pair(sample.SurfaceHessian.squaredNorm(), sample.Radius * sample.Radius + slope).sqrt();
  const double bend = sizes[0] + std::abs(sample.Radius);
  const Pair roots = Pair(bend * bend + 4.0 * slope, distance.SquaredSpread()).sqrt();
  const Pair lengths = Pair(distance.Offset.squaredNorm(), distance.Gradient.squaredNorm()).sqrt();
  return {sizes[1], roots[0], 3.0 * sizes[1] * roots[0], roots[1], lengths[0], lengths[1]};
}
inline SampleSizes SizesOf(const CenteredSurface::SecondOrderSample& sample,
                           const SquaredDistance& distance) noexcept
{
  using Pair = Eigen::Array2d;
  const Pair lengths = Pair(distance.Offset.squaredNorm(), distance.Gradient.squaredNorm()).sqrt();
  return {LargestFirst(sample),
          LargestSecond(sample),
          LargestProduct(sample),
          std::sqrt(distance.SquaredSpread()),
          lengths[0],
          lengths[1]};
}

/// The same lengths of the surface alone.
struct CurveSizes
{
  double First;
  double Second;
  double Product;
};
inline CurveSizes CurveSizesOf(const RadialModel::SecondOrderSample& sample) noexcept
{
  const double slope = sample.SurfaceGradient.squaredNorm();
  const double first = std::sqrt(sample.Radius * sample.Radius + slope);
  const double bend = sample.SurfaceHessian.norm() + std::abs(sample.Radius);
  const double second = std::sqrt(bend * bend + 4.0 * slope);
  return {first, second, 3.0 * first * second};
}
inline CurveSizes CurveSizesOf(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return {LargestFirst(sample), LargestSecond(sample), LargestProduct(sample)};
}

/// The surface's point, relative to its centre, mm.
inline Vector3 PointOf(const Vector3& direction,
                       const RadialModel::SecondOrderSample& sample) noexcept
{
  return sample.Radius * direction;
}
inline Vector3 PointOf(const Vector3&, const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return sample.Point;
}

/// Unit normal.
inline Vector3 NormalOf(const Vector3& direction,
                        const RadialModel::SecondOrderSample& sample) noexcept
{
  return (sample.Radius * direction - sample.SurfaceGradient).normalized();
}
inline Vector3 NormalOf(const Vector3&, const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return NormalOf(sample);
}

/// A direction, the point there relative to the centre (mm), and a normal of any length.
struct EndOfStep
{
  Vector3 Direction;
  Vector3 Point;
  Vector3 Normal;
};
/// The end of a short step (rad, tangent to the sphere) from the sample at `u`, by its expansion.
inline EndOfStep Expanded(const Vector3& u, const RadialModel::SecondOrderSample& sample,
                          const Vector3& step) noexcept
{
  const Vector3& g = sample.SurfaceGradient;
  const Vector3 bent = sample.SurfaceHessian * step;
  const double slope = g.dot(step);
  const double radius = sample.Radius + slope + 0.5 * step.dot(bent);
  const Vector3 end = Moved(u, step);
  const Vector3 surface = radius * end;
  return {end, surface, surface - (g + bent - slope * u)};
}
inline EndOfStep Expanded(const Vector3& u, const CenteredSurface::SecondOrderSample& sample,
                          const Vector3& step) noexcept
{
  const double s = step.dot(sample.Tangents[0]);
  const double t = step.dot(sample.Tangents[1]);
  const Vector3 bentA = s * sample.Second[0] + t * sample.Second[1];
  const Vector3 bentB = s * sample.Second[1] + t * sample.Second[2];
  return {Moved(u, step),
          sample.Point + s * (sample.First[0] + 0.5 * bentA) + t * (sample.First[1] + 0.5 * bentB),
          (sample.First[0] + bentA).cross(sample.First[1] + bentB)};
}
} // namespace palpate
