#pragma once

#include "CenteredSurface.h"
#include "Vector3.h"

#include <cmath>

namespace palpate
{
/// Cross product of the tangents (mm^2/rad^2): along the normal, outward for a surface that is
/// oriented like the sphere of its parameters.
inline Vector3 AreaVector(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  return sample.First[0].cross(sample.First[1]);
}

/// The surface's unit normal; where the tangents are parallel, any unit vector across both.
Vector3 NormalOf(const CenteredSurface::SecondOrderSample& sample) noexcept;

/// Whether both centres of curvature are farther than this (mm) along a unit normal, or on its
/// other side.
inline bool IsBeforeFocus(const CenteredSurface::SecondOrderSample& sample, const Vector3& normal,
                          double distance) noexcept
{
  const auto& [a, b] = sample.First;
  const double aa = a.squaredNorm() - distance * normal.dot(sample.Second[0]);
  const double ab = a.dot(b) - distance * normal.dot(sample.Second[1]);
  const double bb = b.squaredNorm() - distance * normal.dot(sample.Second[2]);
  return aa + bb > 0.0 && aa * bb > ab * ab;
}

/// The root of the larger eigenvalue of [aa ab; ab bb].
inline double LargestRoot(double aa, double ab, double bb) noexcept
{
  const double half = 0.5 * (aa - bb);
  return std::sqrt(0.5 * (aa + bb) + std::sqrt(half * half + ab * ab));
}

/// The largest |x'| (mm/rad) along the great circles through a sample's parameter.
inline double LargestFirst(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  const auto& [a, b] = sample.First;
  return LargestRoot(a.squaredNorm(), a.dot(b), b.squaredNorm());
}

/// At least the largest |x''| (mm/rad^2). With t the angle of a great circle with the first
/// tangent, x'' = m + p cos 2t + q sin 2t.
inline double LargestSecond(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  const Vector3 mean = 0.5 * (sample.Second[0] + sample.Second[2]);
  const Vector3 p = 0.5 * (sample.Second[0] - sample.Second[2]);
  const Vector3& q = sample.Second[1];
  return mean.norm() + LargestRoot(p.squaredNorm(), p.dot(q), q.squaredNorm());
}

/// At least the largest 3 |x'.x''| (mm^2/rad^3). With t as above, x'.x'' is a cubic form of cos t
/// and sin t, the sum of a term in t and one in 3t.
inline double LargestProduct(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  const auto& [a, b] = sample.First;
  const auto& [aa, ab, bb] = sample.Second;
  const double aaa = a.dot(aa);
  const double aab = b.dot(aa) + 2.0 * a.dot(ab);
  const double abb = a.dot(bb) + 2.0 * b.dot(ab);
  const double bbb = b.dot(bb);
  const Eigen::Array2d once(3.0 * aaa + abb, aab + 3.0 * bbb);
  const Eigen::Array2d thrice(aaa - abb, aab - bbb);
  return 0.75 * (once.matrix().norm() + thrice.matrix().norm());
}
} // namespace palpate
