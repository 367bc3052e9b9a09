#pragma once

#include "ParametricSphericalSurface.h"
#include "SphericalHarmonicEvaluator.h"
#include "Vector3.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace palpate
{
/// A parametric surface as searches for closest points need it: points relative to the surface's
/// centre, with the derivatives along the unit sphere of parameters. Immutable; queries are const,
/// thread-safe and allocation-free.
class ParametricShape
{
public:
  struct SecondOrderSample
  {
    Vector3 Point;                ///< relative to the centre, mm
    std::array<Vector3, 2> First; ///< X_a, X_b along Tangents (mm/rad)
    /// X_aa, X_ab, X_bb (mm/rad^2): the covariant Hessian. s^2 X_aa + 2 s t X_ab + t^2 X_bb is the
    /// second derivative along the great circle of s a + t b, if that has length 1.
    std::array<Vector3, 3> Second;
    std::array<Vector3, 2> Tangents; ///< a, b: orthonormal, a x b is the parameter
  };

  explicit ParametricShape(const ParametricSphericalSurface& surface);

  int Degree() const noexcept { return this->MaximumDegree; }
  /// The mean of the surface over the parameters, mm.
  const Vector3& CenterWorld() const noexcept { return this->Center; }
  /// The tables that queries read.
  std::size_t Bytes() const noexcept;

  /// For a unit vector of parameters.
  SecondOrderSample EvaluateSecondOrder(const Vector3& parameter) const noexcept
  {
    SecondOrderSample sample;
    auto& [a, b] = sample.Tangents;
    a = FirstTangent(parameter);
    b = parameter.cross(a);
    for (Eigen::Index k = 0; k < 3; ++k)
    {
      const auto each =
          this->Coordinates[static_cast<std::size_t>(k)].EvaluateSecondOrder(parameter);
      const Vector3 along = each.SurfaceHessian * a;
      sample.Point[k] = each.Radius;
      sample.First[0][k] = each.SurfaceGradient.dot(a);
      sample.First[1][k] = each.SurfaceGradient.dot(b);
      sample.Second[0][k] = along.dot(a);
      sample.Second[1][k] = along.dot(b);
      sample.Second[2][k] = (each.SurfaceHessian * b).dot(b);
    }
    return sample;
  }
  /// mm.
  Vector3 PointWorld(const Vector3& parameter) const noexcept
  {
    return this->Center + Vector3(this->Coordinates[0].Radius(parameter),
                                  this->Coordinates[1].Radius(parameter),
                                  this->Coordinates[2].Radius(parameter));
  }

private:
  // Without a branch; continuous in each half of the sphere (Duff et al., "Building an orthonormal
  // basis, revisited", J. Computer Graphics Techniques 6, 2017).
  static Vector3 FirstTangent(const Vector3& u) noexcept
  {
    const double sign = std::copysign(1.0, u[2]);
    const double factor = -1.0 / (sign + u[2]);
    return {1.0 + sign * u[0] * u[0] * factor, sign * u[0] * u[1] * factor, -sign * u[0]};
  }

  Vector3 Center;
  std::array<SphericalHarmonicEvaluator, 3> Coordinates; // without their means
  int MaximumDegree;
};
} // namespace palpate
