#include "CenteredSurfaceSample.h"

namespace palpate
{
Vector3 NormalOf(const CenteredSurface::SecondOrderSample& sample) noexcept
{
  const Vector3 area = AreaVector(sample);
  const double size = area.norm();
  if (size > 0.0)
  {
    return area / size;
  }
  const auto& [a, b] = sample.First;
  const Vector3& longer = a.squaredNorm() < b.squaredNorm() ? b : a;
  return longer.squaredNorm() > 0.0 ? longer.unitOrthogonal() : Vector3(Vector3::UnitZ());
}
} // namespace palpate
