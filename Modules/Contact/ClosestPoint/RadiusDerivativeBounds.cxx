#include "RadiusDerivativeBounds.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// Largest magnitude of an eigenvalue of a tangent Hessian.
double Norm(const Matrix3& hessian)
{
  const double half = 0.5 * hessian.trace();
  const double spread = std::sqrt(std::max(0.0, 0.5 * hessian.squaredNorm() - half * half));
  return std::abs(half) + spread;
}
} // namespace

RadiusDerivativeBounds::RadiusDerivativeBounds(const RadialModel& model) : Radius{}
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
  const double fall = std::cos(degree * sphere.LargestGap());
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
