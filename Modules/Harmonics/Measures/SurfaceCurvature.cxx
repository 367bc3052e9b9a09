#include "SurfaceCurvature.h"

#include <cmath>

namespace palpate
{
namespace
{
// From the second form in an orthonormal basis of the tangent plane.
SurfaceCurvature FromSecondForm(const std::array<double, 3>& form,
                                const std::array<Vector3, 2>& tangents)
{
  const auto& [s00, s01, s11] = form;
  const double mean = 0.5 * (s00 + s11);
  const double half = 0.5 * (s00 - s11);
  const double spread = std::hypot(half, s01);
  const double angle = 0.5 * std::atan2(s01, half);
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {mean,
          s00 * s11 - s01 * s01,
          {mean + spread, mean - spread},
          {c * tangents[0] + s * tangents[1], c * tangents[1] - s * tangents[0]}};
}
} // namespace

SurfaceCurvature CurvatureAt(const Vector3& direction,
                             const RadialModel::SecondOrderSample& sample) noexcept
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
  return FromSecondForm({second(t[0], t[0]), second(t[0], t[1]), second(t[1], t[1])},
                        {onSurface(t[0]), onSurface(t[1])});
}

SurfaceCurvature CurvatureAt(const SurfaceModel::SecondOrderSample& sample) noexcept
{
  const auto& [xa, xb] = sample.First;
  const auto& [xaa, xab, xbb] = sample.Second;
  const Vector3 area = xa.cross(xb);
  const Vector3 outward = area / area.norm();
  // Along X_a, and perpendicular to it: X_b - q X_a.
  const double stretch = xa.norm();
  const double q = xa.dot(xb) / (stretch * stretch);
  const double width = area.norm() / stretch;
  const double aa = -outward.dot(xaa);
  const double ab = -outward.dot(xab);
  const double bb = -outward.dot(xbb);
  return FromSecondForm({aa / (stretch * stretch), (ab - q * aa) / (stretch * width),
                         (bb - 2.0 * q * ab + q * q * aa) / (width * width)},
                        {xa / stretch, (xb - q * xa) / width});
}
} // namespace palpate
