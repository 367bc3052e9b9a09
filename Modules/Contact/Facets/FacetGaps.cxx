#include "FacetGaps.h"

#include "RigidProxy.h"

#include <algorithm>
#include <limits>

namespace palpate
{
namespace
{
ProvenBall NeverSeen()
{
  return {Vector3::Constant(std::numeric_limits<double>::max()), 0.0};
}
} // namespace

FacetGaps::FacetGaps(std::shared_ptr<const FacetTree> tree, const ToolSkeleton& tool,
                     const SurfaceFriction& friction)
    : ToolGaps(tool, friction), Tree(std::move(tree))
{
  for (const ToolSkeleton::Ball& ball : tool.Balls())
  {
    Part part;
    part.Ball = ball;
    part.Seen = NeverSeen();
    this->Parts.push_back(part);
  }
  for (const ToolSkeleton::Cluster& cluster : tool.Clusters())
  {
    this->Groups.push_back({cluster, NeverSeen()});
  }
}

// The nearest point may have changed where the way is longer than this: planes are wrong by its
// square by the edges' distances.
bool FacetGaps::HasMoved(const Part& part, const Vector3& centerWorld) noexcept
{
  constexpr double Exact = 1e-6;  // mm^2
  constexpr double PerGap = 0.02; // mm
  const double gap = std::max(part.Seen.Distance - part.Ball.Radius, 0.0);
  return (centerWorld - part.Seen.CenterWorld).squaredNorm() > Exact + PerGap * gap;
}

// A wall that was the nearest stays one, as a plane, while the ball is near where it saw it and the
// nearest one is another.
void FacetGaps::LookAround(Part& part, const Vector3& centerWorld) const noexcept
{
  constexpr double StaysFor = 0.5;   // mm
  constexpr double SameSide = 0.985; // cosine of 10 degrees
  const double within = part.Ball.Radius + WallsWithin;
  const FacetTree::Nearest nearest = this->Tree->NearestTo(centerWorld, within);
  part.Seen = {centerWorld, std::min(nearest.Distance, within)};
  if (!(nearest.Distance <= within) || nearest.Distance <= 0.0)
  {
    part.WallCount = 0;
    return;
  }
  const Vector3 normal = (centerWorld - nearest.PointWorld) / nearest.Distance;
  std::array<Wall, MostWalls> walls;
  std::size_t count = 0;
  walls[count++] = {nearest.PointWorld, normal, centerWorld};
  for (std::size_t n = 0; n < part.WallCount && count < MostWalls; ++n)
  {
    const Wall& wall = part.Walls[n];
    const bool isKnown =
        std::any_of(walls.begin(), walls.begin() + count,
                    [&](const Wall& other) { return other.Normal.dot(wall.Normal) > SameSide; });
    if (!isKnown && (centerWorld - wall.SeenFrom).norm() < StaysFor)
    {
      walls[count++] = wall;
    }
  }
  part.Walls = walls;
  part.WallCount = count;
}

// Returns how far (mm) the mesh is from the ball, at least.
double FacetGaps::GatherOf(std::size_t number, const ToolPose& pose,
                           PoseConstraints& limits) noexcept
{
  Part& part = this->Parts[number];
  const Vector3 center = pose.PositionWorld + pose.Orientation * part.Ball.Center;
  if (HasMoved(part, center))
  {
    this->LookAround(part, center);
  }
  for (std::size_t n = 0; n < part.WallCount; ++n)
  {
    const Wall& wall = part.Walls[n];
    const double gap = wall.Normal.dot(center - wall.PointWorld) - part.Ball.Radius;
    this->AddWall(pose, part.Ball, number, {wall.Normal, gap, n}, limits);
  }
  return part.Seen.DistanceAt(center) - part.Ball.Radius;
}

// Of the whole group, at least; asked again only where it may have come near.
double FacetGaps::DistanceOf(Group& group, const Vector3& centerWorld) const noexcept
{
  constexpr double Renewed = 0.5; // mm
  const double within = group.Cluster.Radius + 2.0 * WallsWithin;
  const bool hasMoved = (centerWorld - group.Seen.CenterWorld).norm() > Renewed;
  if (group.Seen.DistanceAt(centerWorld) - group.Cluster.Radius < RigidProxy::Margin && hasMoved)
  {
    group.Seen = {centerWorld,
                  std::min(this->Tree->NearestTo(centerWorld, within).Distance, within)};
  }
  return group.Seen.DistanceAt(centerWorld) - group.Cluster.Radius;
}

double FacetGaps::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  double nearest = std::numeric_limits<double>::max();
  for (Group& group : this->Groups)
  {
    const ToolSkeleton::Cluster& cluster = group.Cluster;
    const double away =
        this->DistanceOf(group, pose.PositionWorld + pose.Orientation * cluster.Center);
    if (away >= RigidProxy::Margin)
    {
      nearest = std::min(nearest, away);
      continue;
    }
    for (std::size_t n = cluster.Begin; n < cluster.End; ++n)
    {
      nearest = std::min(nearest, this->GatherOf(n, pose, limits));
    }
  }
  return nearest;
}

bool FacetGaps::IsFreeAt(const ToolPose& pose) noexcept
{
  return std::all_of(this->Parts.begin(), this->Parts.end(),
                     [&](const Part& part)
                     {
                       const Vector3 center =
                           pose.PositionWorld + pose.Orientation * part.Ball.Center;
                       const double room = std::max(part.Ball.Radius - Slack, 0.0);
                       return !this->Tree->IsInside(center) &&
                              !(this->Tree->NearestTo(center, room).Distance < room);
                     });
}
} // namespace palpate
