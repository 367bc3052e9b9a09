#include "ToolGaps.h"

#include "RigidProxy.h"

namespace palpate
{
void ToolGaps::AddWall(const ToolPose& pose, const ToolSkeleton::Ball& ball, std::size_t ballNumber,
                       const Wall& wall, PoseConstraints& limits) const noexcept
{
  constexpr std::size_t WallsOfBall = 8;
  if (wall.Gap >= RigidProxy::InTheWay)
  {
    return;
  }
  const Vector3 normal = pose.Orientation.conjugate() * wall.Normal;
  const Vector3 point = this->Tool.PointAgainst(normal, ball);
  PoseConstraint limit;
  limit.Arm = pose.Orientation * point;
  limit.Normal = wall.Normal;
  limit.Gap = wall.Gap + normal.dot(point - ball.Center) + ball.Radius;
  limit.Friction = this->Friction;
  limit.Cuts = ball.Cuts;
  limit.Source = ballNumber * WallsOfBall + wall.Number;
  limits.Add(limit);
}
} // namespace palpate
