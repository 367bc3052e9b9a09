#include "HalfSpace.h"

#include <algorithm>

namespace palpate
{
RayInterval ClippedInterval(const FieldRay& ray, const std::vector<HalfSpace>& kept,
                            RayInterval interval) noexcept
{
  for (const HalfSpace& half : kept)
  {
    const double height = half.Normal.dot(ray.Origin) + half.Offset;
    const double rise = half.Normal.dot(ray.Direction);
    if (rise > 0.0)
    {
      interval.From = std::max(interval.From, -height / rise);
    }
    else if (rise < 0.0)
    {
      interval.To = std::min(interval.To, -height / rise);
    }
    else if (!(height >= 0.0))
    {
      interval.To = -1.0;
      interval.From = 1.0;
    }
  }
  return interval;
}
} // namespace palpate
