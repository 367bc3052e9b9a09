#pragma once

#include "ParametricShape.h"
#include "Vector3.h"

#include <cmath>

namespace palpate
{
/// Cross product of the tangents (mm^2/rad^2): along the normal, outward for a surface that is
/// oriented like the sphere of its parameters.
inline Vector3 AreaVector(const ParametricShape::SecondOrderSample& sample) noexcept
{
  return sample.First[0].cross(sample.First[1]);
}

/// The surface's unit normal; where the tangents are parallel, any unit vector across both.
Vector3 NormalOf(const ParametricShape::SecondOrderSample& sample) noexcept;

/// The root of the larger eigenvalue of [aa ab; ab bb].
inline double LargestRoot(double aa, double ab, double bb) noexcept
{
  const double half = 0.5 * (aa - bb);
  return std::sqrt(0.5 * (aa + bb) + std::sqrt(half * half + ab * ab));
}

/// The largest |x'| (mm/rad) along the great circles through a sample's parameter.
inline double LargestFirst(const ParametricShape::SecondOrderSample& sample) noexcept
{
  const auto& [a, b] = sample.First;
  return LargestRoot(a.squaredNorm(), a.dot(b), b.squaredNorm());
}

/// At least the largest |x''| (mm/rad^2). With t the angle of a great circle with the first
/// tangent, x'' = m + p cos 2t + q sin 2t.
inline double LargestSecond(const ParametricShape::SecondOrderSample& sample) noexcept
{
  const Vector3 mean = 0.5 * (sample.Second[0] + sample.Second[2]);
  const Vector3 p = 0.5 * (sample.Second[0] - sample.Second[2]);
  const Vector3& q = sample.Second[1];
  return mean.norm() + LargestRoot(p.squaredNorm(), p.dot(q), q.squaredNorm());
}
} // namespace palpate
