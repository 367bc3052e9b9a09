#include "SurfaceCurvature.h"

#include <cmath>

namespace palpate
{
SurfaceCurvature CurvatureAt(const Vector3& direction,
                             const SphericalHarmonicModel::SecondOrderSample& sample) noexcept
{
  const double radius = sample.Radius;
  const double size = std::abs(radius);
  const Vector3& g = sample.SurfaceGradient;
  const double stretch = std::sqrt(radius * radius + g.squaredNorm());
  const auto second = [&](const Vector3& a, const Vector3& b)
  {
    return (radius * (radius * a.dot(b) - a.dot(sample.SurfaceHessian * b)) +
            2.0 * g.dot(a) * g.dot(b)) /
           stretch;
  };
  // The inverse square root of the first form turns orthonormal tangents of the sphere into
  // tangents whose images on the surface are orthonormal.
  const auto unstretched = [&](const Vector3& t) -> Vector3
  { return (t - g.dot(t) / (stretch * (stretch + size)) * g) / size; };
  const auto onSurface = [&](const Vector3& t) -> Vector3
  { return radius * t + g.dot(t) * direction; };

  const Vector3 first = direction.unitOrthogonal();
  const std::array<Vector3, 2> t{unstretched(first), unstretched(direction.cross(first))};
  const double s00 = second(t[0], t[0]);
  const double s01 = second(t[0], t[1]);
  const double s11 = second(t[1], t[1]);
  const double mean = 0.5 * (s00 + s11);
  const double half = 0.5 * (s00 - s11);
  const double spread = std::hypot(half, s01);
  const double angle = 0.5 * std::atan2(s01, half);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {mean,
          s00 * s11 - s01 * s01,
          {mean + spread, mean - spread},
          {onSurface(c * t[0] + s * t[1]), onSurface(c * t[1] - s * t[0])}};
}
} // namespace palpate
