#include "ReachingScale.h"

#include <algorithm>

namespace palpate
{
double ReachingScale(const TouchScene& scene, const DeviceCapabilities& device)
{
  constexpr double Spare = 1.2;
  const double reach =
      0.5 * scene.BoundsWorld().sizes().maxCoeff() + 2.0 * scene.Tool.BoundingRadius();
  const double half = 0.5 * device.Workspace.sizes().minCoeff();
  return half > 0.0 ? std::max(1.0, Spare * reach / half) : 1.0;
}
} // namespace palpate
