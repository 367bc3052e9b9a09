#include "SurfacePatch.h"

namespace palpate
{
SurfacePatch::SurfacePatch(const Vector3& direction, const RadialModel::SecondOrderSample& sample,
                           double reach, double pointThird) noexcept
    : Point(sample.Radius * direction)
{
  const double radius = sample.Radius;
  const Vector3& g = sample.SurfaceGradient;
  const Vector3 area = radius * direction - g;
  const double stretch = area.norm();
  this->Normal = stretch > 0.0 ? Vector3(area / stretch) : direction;
  const double scale = stretch > 0.0 ? 1.0 / stretch : 0.0;

  // Normal part of x'' for unit tangents: (R (t.H t - R) - 2 (g.t)^2) / stretch.
  const Vector3 t = direction.unitOrthogonal();
  const Vector3 s = direction.cross(t);
  const auto form = [&](const Vector3& a, const Vector3& b)
  {
    return scale * (radius * (a.dot(sample.SurfaceHessian * b) - radius * a.dot(b)) -
                    2.0 * g.dot(a) * g.dot(b));
  };
  const double mean = 0.5 * (form(t, t) + form(s, s));
  const double spread = std::hypot(0.5 * (form(t, t) - form(s, s)), form(t, s));

  const double half = 0.5 * reach * reach;
  const double rest = half * reach * pointThird / 3.0;
  this->High = half * std::max(0.0, mean + spread) + rest;
  this->Low = half * std::min(0.0, mean - spread) - rest;
  const double bend = sample.SurfaceHessian.norm() + std::abs(radius);
  this->Radius = reach * stretch + half * std::sqrt(bend * bend + 4.0 * g.squaredNorm()) + rest;
}
} // namespace palpate
