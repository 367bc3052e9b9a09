#include "SurfaceBox.h"

#include "CenteredSurfaceSample.h"

namespace palpate
{
namespace
{
// In the tangent plane at the sample, where the parameters are stretched most.
Vector3 MostStretched(const CenteredSurface::SecondOrderSample& sample, const Vector3& normal)
{
  const auto& [a, b] = sample.First;
  const double angle = 0.5 * std::atan2(2.0 * a.dot(b), a.squaredNorm() - b.squaredNorm());
  const Vector3 along = std::cos(angle) * a + std::sin(angle) * b;
  const Vector3 tangent = along - along.dot(normal) * normal;
  const double length = tangent.norm();
  return length > 0.0 ? Vector3(tangent / length) : normal.unitOrthogonal();
}
} // namespace

// Along each great circle x(s) = x + s x' + s^2 x'' / 2 up to s^3 |x'''| / 6; so is each
// coordinate.
SurfaceBox::SurfaceBox(const Vector3&, const CenteredSurface::SecondOrderSample& sample,
                       double reach, double pointThird) noexcept
    : Point(sample.Point)
{
  const Vector3 normal = NormalOf(sample);
  const Vector3 first = MostStretched(sample, normal);
  this->Axes << first, normal.cross(first), normal;
  const double half = 0.5 * reach * reach;
  const double rest = half * reach * pointThird / 3.0;
  for (Eigen::Index i = 0; i < 3; ++i)
  {
    const Vector3 axis = this->Axes.col(i);
    const double slope = std::hypot(sample.First[0].dot(axis), sample.First[1].dot(axis));
    const double aa = sample.Second[0].dot(axis);
    const double bb = sample.Second[2].dot(axis);
    const double mean = 0.5 * (aa + bb);
    const double spread = std::hypot(0.5 * (aa - bb), sample.Second[1].dot(axis));
    const double away = reach * slope + rest;
    this->High[i] = half * std::max(0.0, mean + spread) + away;
    this->Low[i] = half * std::min(0.0, mean - spread) - away;
  }
}
} // namespace palpate
