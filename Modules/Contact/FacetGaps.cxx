#include "FacetGaps.h"

#include "RigidProxy.h"

#include <algorithm>
#include <limits>

namespace palpate
{
FacetGaps::FacetGaps(std::shared_ptr<const FacetTree> tree, const ToolSkeleton& tool,
                     const SurfaceFriction& friction)
    : Tree(std::move(tree)), Friction(friction)
{
  for (const ToolSkeleton::Ball& ball : tool.Balls())
  {
    Part part;
    part.Ball = ball;
    this->Parts.push_back(part);
  }
}

// Returns the distance (mm) of the mesh from the ball's centre, or of all that is searched. A wall
// that was the nearest stays one, as a plane, while the ball is near where it saw it and the
// nearest one is another.
double FacetGaps::LookAround(Part& part, const Vector3& centerWorld) const noexcept
{
  constexpr double StaysFor = 0.5;   // mm
  constexpr double SameSide = 0.985; // cosine of 10 degrees
  const double within = part.Ball.Radius + 2.0 * RigidProxy::Margin;
  const FacetTree::Nearest nearest = this->Tree->NearestTo(centerWorld, within);
  if (!(nearest.Distance <= within) || nearest.Distance <= 0.0)
  {
    part.WallCount = 0;
    return within;
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
  return nearest.Distance;
}

double FacetGaps::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t number = 0; number < this->Parts.size(); ++number)
  {
    Part& part = this->Parts[number];
    const Vector3 arm = pose.Orientation * part.Ball.Center;
    const Vector3 center = pose.PositionWorld + arm;
    nearest = std::min(nearest, this->LookAround(part, center) - part.Ball.Radius);
    for (std::size_t n = 0; n < part.WallCount; ++n)
    {
      const Wall& wall = part.Walls[n];
      const double gap = wall.Normal.dot(center - wall.PointWorld) - part.Ball.Radius;
      if (gap < RigidProxy::Margin)
      {
        limits.Add({arm - part.Ball.Radius * wall.Normal, wall.Normal, gap, this->Friction,
                    number * SourcesOfPart + n});
      }
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
