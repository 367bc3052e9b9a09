#include "PoseMap.h"

#include "Units.h"

namespace palpate
{
Eigen::Quaterniond TurnOf(const TaskPose& pose)
{
  const double angle = pose.Turn.norm() / DegreesPerRadian;
  return Eigen::Quaterniond(angle > 0.0 ? Eigen::AngleAxisd(angle, pose.Turn.normalized())
                                        : Eigen::AngleAxisd::Identity());
}

Eigen::Affine3d MapOf(const TaskPose& pose, const Vector3& centerWorld)
{
  return Eigen::Translation3d(centerWorld + pose.Shift) * TurnOf(pose) *
         Eigen::Translation3d(-centerWorld);
}

TaskPose PoseOf(const Eigen::Affine3d& map, const Vector3& centerWorld)
{
  const Eigen::AngleAxisd turn{Matrix3(map.rotation())};
  return {map * centerWorld - centerWorld, DegreesPerRadian * turn.angle() * turn.axis()};
}
} // namespace palpate
