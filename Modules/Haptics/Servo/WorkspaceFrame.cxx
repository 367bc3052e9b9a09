#include "WorkspaceFrame.h"

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

WorkspaceFrame WorkspaceFrame::Around(const TouchScene& scene, const DeviceCapabilities& device)
{
  WorkspaceFrame frame;
  if (!scene.Structures.empty())
  {
    frame.Scale = ReachingScale(scene, device);
    frame.CenterWorld = scene.BoundsWorld().center();
  }
  return frame;
}
} // namespace palpate
