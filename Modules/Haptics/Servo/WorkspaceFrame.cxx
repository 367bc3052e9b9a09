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

Vector3 WorkspaceFrame::NearestInReach(const Vector3& pointWorld,
                                       const Eigen::AlignedBox3d& workspace) const
{
  const Vector3 wanted = this->ToDevice(pointWorld);
  return workspace.isEmpty() ? wanted : wanted.cwiseMax(workspace.min()).cwiseMin(workspace.max());
}

Vector3 WorkspaceFrame::FirstHand(const Vector3& towardsViewerWorld,
                                  const Eigen::AlignedBox3d& workspace) const
{
  if (workspace.isEmpty())
  {
    return Vector3::Zero();
  }
  const Vector3 middle = this->NearestInReach(this->CenterWorld, workspace);
  const Vector3 path = this->Rotation.transpose() * towardsViewerWorld.normalized();
  double reach = workspace.diagonal().norm();
  for (int axis = 0; axis < 3; ++axis)
  {
    const double side = path[axis] > 0.0 ? workspace.max()[axis] : workspace.min()[axis];
    // A direction parallel to a pair of sides meets neither.
    reach = path[axis] != 0.0 ? std::min(reach, (side - middle[axis]) / path[axis]) : reach;
  }
  return middle + reach * path;
}
} // namespace palpate
