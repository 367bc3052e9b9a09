#include "FieldGaps.h"

#include "RigidProxy.h"
#include "ToolSkeleton.h"

#include <algorithm>
#include <utility>

namespace palpate
{
// Half a voxel is known around any surface; a stride may not leap over the reach.
FieldGaps::FieldGaps(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
                     const SurfaceFriction& friction)
    : Solid(std::move(solid)), Friction(friction), Radius(tool.Skeleton()->Balls().front().Radius),
      Extent(tool.BoundingRadius()),
      Reach(std::max(0.5 * Solid->VoxelSize(), 1.2 * RigidProxy::Stride))
{
  for (std::size_t n = 0; n < tool.Points().size(); ++n)
  {
    const Vector3 outward = -tool.Normals()[n];
    this->Points.push_back({tool.Points()[n] - this->Radius * outward, outward});
  }
  this->Places.resize(this->Points.size());
  this->Inside.resize(this->Points.size());
}

double FieldGaps::DistanceToBounds(const ToolPose& pose) const noexcept
{
  return this->Solid->BoundsWorld().exteriorDistance(pose.PositionWorld) - this->Extent;
}

void FieldGaps::PlaceAll(const ToolPose& pose, double lifted) noexcept
{
  const Matrix3 turned = pose.Orientation.toRotationMatrix();
  for (std::size_t n = 0; n < this->Points.size(); ++n)
  {
    const Point& point = this->Points[n];
    this->Places[n] =
        pose.PositionWorld + turned * (point.Axis + (this->Radius + lifted) * point.Outward);
  }
  this->Solid->AreInside(this->Places.data(), this->Places.size(), this->Inside.data());
}

void FieldGaps::AddFoot(const ToolPose& pose, std::size_t number,
                        PoseConstraints& limits) const noexcept
{
  constexpr int Slides = 3;
  const Vector3 axis = pose.Orientation * this->Points[number].Axis;
  Vector3 inward = -(pose.Orientation * this->Points[number].Outward);
  PoseConstraint foot;
  FieldSolid::Wall wall;
  for (int slide = 0; slide < Slides; ++slide)
  {
    foot.Arm = axis - this->Radius * inward;
    wall = this->Solid->WallNear(pose.PositionWorld + foot.Arm, inward);
    if (!wall.IsKnown || wall.Distance > RigidProxy::Margin)
    {
      return;
    }
    inward = wall.Normal;
  }
  const bool isKnown = std::any_of(limits.begin(), limits.end(),
                                   [&](const PoseConstraint& other)
                                   { return (other.Arm - foot.Arm).norm() < 0.1 * this->Radius; });
  if (!isKnown)
  {
    foot.Normal = wall.Normal;
    foot.Gap = wall.Distance;
    foot.Friction = this->Friction;
    foot.Source = number;
    limits.Add(foot);
  }
}

double FieldGaps::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  const double away = this->DistanceToBounds(pose);
  if (away > RigidProxy::Margin)
  {
    return away;
  }
  this->PlaceAll(pose, this->Reach);
  for (std::size_t n = 0; n < this->Points.size(); ++n)
  {
    if (this->Inside[n] != 0)
    {
      this->AddFoot(pose, n, limits);
    }
  }
  return 0.0; // what is beyond the reach is unknown
}

bool FieldGaps::IsFreeAt(const ToolPose& pose) noexcept
{
  if (this->DistanceToBounds(pose) > 0.0)
  {
    return true;
  }
  this->PlaceAll(pose, -std::min(std::max(Slack, 0.25 * this->Solid->VoxelSize()), this->Radius));
  return std::none_of(this->Inside.begin(), this->Inside.end(),
                      [](unsigned char inside) { return inside != 0; });
}
} // namespace palpate
