#pragma once

#include "RadialModel.h"
#include "SphericalHarmonicProjection.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <vector>

namespace palpate::test
{
/// The model of a given degree closest to a radius function (mm): coefficients by quadrature fine
/// enough for the terms that the degree omits.
inline RadialModel Project(int degree, const std::function<double(const Vector3&)>& radius,
                           const Vector3& centerWorld = Vector3::Zero())
{
  const int fine = std::max(4 * degree, 2 * degree + 80);
  return {degree, ProjectOnHarmonics(degree, fine, radius), centerWorld};
}

/// An ellipsoid with these half axes along the columns of `rotation`.
inline RadialModel Ellipsoid(const Vector3& axes, const Matrix3& rotation, int degree)
{
  return Project(degree, [axes, rotation](const Vector3& u)
                 { return 1.0 / (rotation.transpose() * u).cwiseQuotient(axes).norm(); });
}

/// A sphere whose centre is `offset` from the model's centre; exact for offset zero.
inline RadialModel OffCenterSphere(double radius, const Vector3& offset, int degree)
{
  return Project(degree,
                 [radius, offset](const Vector3& u)
                 {
                   const double along = offset.dot(u);
                   return along + std::sqrt(radius * radius - offset.squaredNorm() + along * along);
                 });
}

/// The sphere around `centerWorld`.
inline RadialModel Sphere(double radius, const Vector3& centerWorld = Vector3::Zero())
{
  return {0, {radius * std::sqrt(4.0 * M_PI)}, centerWorld};
}
} // namespace palpate::test
