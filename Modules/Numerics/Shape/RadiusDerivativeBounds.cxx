#include "RadiusDerivativeBounds.h"

#include "IcosahedronDirections.h"
#include "SphericalTriangle.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// The largest angle (rad) from any direction to the closest of these: at most the distance of a
// triangle's corners from its centre.
double Gap(const IcosahedronDirections& sphere)
{
  double gap = 0.0;
  for (const auto& [a, b, c] : sphere.Triangles())
  {
    const auto at = [&](int corner)
    { return sphere.Directions()[static_cast<std::size_t>(corner)]; };
    gap = std::max(gap, SphericalTriangle{{at(a), at(b), at(c)}}.Cap().Radius);
  }
  return gap;
}

// Largest magnitude of an eigenvalue of a tangent Hessian.
double Norm(const Matrix3& hessian)
{
  const double half = 0.5 * hessian.trace();
  const double spread = std::sqrt(std::max(0.0, 0.5 * hessian.squaredNorm() - half * half));
  return std::abs(half) + spread;
}
} // namespace

RadiusDerivativeBounds::RadiusDerivativeBounds(const SphericalHarmonicModel& model) : Radius{}
{
  const double degree = model.Degree();
  const IcosahedronDirections sphere(std::max(1, model.Degree()));
  for (const Vector3& direction : sphere.Directions())
  {
    const auto sample = model.EvaluateSecondOrder(direction);
    this->Radius[0] = std::max(this->Radius[0], std::abs(sample.Radius));
    this->Radius[1] = std::max(this->Radius[1], sample.SurfaceGradient.norm());
    this->Radius[2] = std::max(this->Radius[2], Norm(sample.SurfaceHessian));
  }
  const double fall = std::cos(degree * Gap(sphere));
  for (double& bound : this->Radius)
  {
    bound /= fall;
  }
  this->Radius[3] = degree * this->Radius[2];
  // With e the arc's direction: (R e)''' = (R''' - 3 R') e + (3 R'' - R) e'.
  const double along =
      std::hypot(this->Radius[3] + 3.0 * this->Radius[1], 3.0 * this->Radius[2] + this->Radius[0]);
  // A symmetric form is largest with three equal arguments; the asymmetric part of the covariant
  // derivative is the curvature of the sphere, 1, times x'.
  this->PointThird = along + std::hypot(this->Radius[1], this->Radius[0]);
}
} // namespace palpate
