#include "OrganGaps.h"

#include "ContactWedge.h"
#include "RigidProxy.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace palpate
{
namespace
{
constexpr double Skin = 0.05;      // mm
constexpr double Room = 0.5;       // mm, around a ball
constexpr int SearchesOfTick = 20; // of some microseconds
constexpr int WorkOfSearch = 100;  // evaluations
} // namespace

template <typename Surface>
OrganGaps<Surface>::OrganGaps(std::shared_ptr<const Surface> surface, const ToolSkeleton& tool,
                              const SurfaceFriction& friction)
    : ToolGaps(tool, friction), Touched(std::move(surface)), Parts(tool.Balls().size()),
      Groups(tool.Clusters().size())
{
  double thickest = 0.0;
  for (std::size_t number = 0; number < this->Parts.size(); ++number)
  {
    this->Parts[number].Ball = tool.Balls()[number];
    thickest = std::max(thickest, tool.Balls()[number].Radius);
  }
  for (std::size_t number = 0; number < this->Groups.size(); ++number)
  {
    this->Groups[number].Cluster = tool.Clusters()[number];
  }
  if constexpr (Surface::MayCrossItself)
  {
    this->Places = this->Touched->PlacesFor(thickest, Room);
  }
  else
  {
    this->Fits = !ContactWedgeOf<Surface>::IsNeeded(*this->Touched, thickest + Room);
  }
}

// Whether its one wall is the nearest of all, and the only one within Room.
template <typename Surface>
bool OrganGaps<Surface>::FitsWhereItIs(const Part& part) const noexcept
{
  if (part.WallCount != 1 || part.Walls[0].SignedDistance > part.Ball.Radius + Room)
  {
    return false;
  }
  if constexpr (Surface::MayCrossItself)
  {
    return this->Places->IsNearest(part.Walls[0]);
  }
  return this->Fits;
}

// By so much that the tangent planes of its walls stand for them no longer: they are wrong by the
// square of the way by the surface's radius of curvature, of millimetres.
template <typename Surface>
bool OrganGaps<Surface>::HasMoved(const Part& part, const Vector3& centerWorld) const noexcept
{
  constexpr double Exact = 1e-6;  // mm^2
  constexpr double PerGap = 0.02; // mm
  double nearest = part.WallCount > 0 ? std::numeric_limits<double>::max() : 0.0;
  for (std::size_t n = 0; n < part.WallCount; ++n)
  {
    nearest = std::min(nearest, part.Walls[n].SignedDistance - part.Ball.Radius);
  }
  return (centerWorld - part.TrackedAt).squaredNorm() > Exact + PerGap * std::max(nearest, 0.0);
}

template <typename Surface>
void OrganGaps<Surface>::BeginTick() noexcept
{
  this->SearchesLeft = SearchesOfTick;
}

template <typename Surface>
void OrganGaps<Surface>::Search(Part& part, const Vector3& centerWorld) noexcept
{
  const ClosestPoint found =
      part.HasSearched
          ? this->Touched->Search().Clearance(centerWorld, part.Ball.Radius, WorkOfSearch,
                                              part.Found)
          : this->Touched->Search().Clearance(centerWorld, part.Ball.Radius, WorkOfSearch);
  if (found.State == ClosestPoint::Outcome::BadInput)
  {
    return;
  }
  part.Searched = {centerWorld, std::abs(found.SignedDistance) - found.DistanceError};
  part.HasSearched = true;
  part.Found = found;
  this->Keep(part, found);
}

// A wall is known already if its point is.
template <typename Surface>
void OrganGaps<Surface>::Keep(Part& part, const ClosestPoint& found) noexcept
{
  constexpr double SamePlace = 0.02; // mm
  for (std::size_t n = 0; n < part.WallCount; ++n)
  {
    if ((part.Walls[n].PointWorld - found.PointWorld).norm() < SamePlace)
    {
      part.Walls[n] = found;
      return;
    }
  }
  if (part.WallCount < MostWalls)
  {
    part.Walls[part.WallCount++] = found;
    return;
  }
  part.Walls[part.NextWall] = found;
  part.NextWall = (part.NextWall + 1) % MostWalls;
}

// Walls that are no minima any more, or too far to matter, are forgotten; so is one of two that
// have become one.
template <typename Surface>
void OrganGaps<Surface>::Track(Part& part, const Vector3& centerWorld) noexcept
{
  constexpr double Same = 1e-3; // mm
  std::size_t kept = 0;
  for (std::size_t n = 0; n < part.WallCount; ++n)
  {
    const ClosestPoint wall = this->Touched->Search().Track(centerWorld, part.Walls[n]);
    const bool isNear =
        wall.Converged() && std::abs(wall.SignedDistance) < part.Ball.Radius + WallsWithin;
    const bool isNew = std::none_of(part.Walls.begin(), part.Walls.begin() + kept,
                                    [&](const ClosestPoint& other)
                                    { return (other.PointWorld - wall.PointWorld).norm() < Same; });
    if (isNear && isNew)
    {
      part.Walls[kept++] = wall;
    }
  }
  part.WallCount = kept;
  part.TrackedAt = centerWorld;
}

// mm from the nearest wall of all to any ball of the group, at least. What a search has proven
// serves until the group has moved on.
template <typename Surface>
double OrganGaps<Surface>::LookAround(Group& group, const Vector3& centerWorld) noexcept
{
  constexpr double Renewed = 0.5; // mm
  const double known = group.Searched.DistanceAt(centerWorld) - group.Cluster.Radius;
  const bool hasMoved =
      !group.HasSearched || (centerWorld - group.Searched.CenterWorld).norm() > Renewed;
  if (known >= RigidProxy::Margin || !hasMoved || this->SearchesLeft <= 0)
  {
    return known;
  }
  --this->SearchesLeft;
  const ClosestPoint found =
      group.HasSearched
          ? this->Touched->Search().Clearance(centerWorld, group.Cluster.Radius, WorkOfSearch,
                                              group.Found)
          : this->Touched->Search().Clearance(centerWorld, group.Cluster.Radius, WorkOfSearch);
  if (found.State == ClosestPoint::Outcome::BadInput)
  {
    return known;
  }
  group.Searched = {centerWorld, std::abs(found.SignedDistance) - found.DistanceError};
  group.HasSearched = true;
  group.Found = found;
  return group.Searched.Distance - group.Cluster.Radius;
}

// Returns whether a wall may be near. A ball without a wall follows the group's from there. The
// whole surface is searched where one that is unknown could be in the ball, as long as the tick has
// time for it; what is left has its turn in the next one.
template <typename Surface>
bool OrganGaps<Surface>::LookAround(Part& part, const Group& group, const Vector3& centerWorld,
                                    PoseConstraints& limits) noexcept
{
  const double unknown = UnknownAt(part, group, centerWorld);
  if (unknown >= RigidProxy::Margin)
  {
    return false;
  }
  const bool isNew = part.WallCount == 0 && group.HasSearched;
  if (isNew)
  {
    this->Keep(part, group.Found);
  }
  if (isNew || this->HasMoved(part, centerWorld))
  {
    this->Track(part, centerWorld);
  }
  const bool isDue = (unknown <= -Skin || part.WallCount == 0) && !this->FitsWhereItIs(part);
  if (isDue && this->SearchesLeft > 0)
  {
    --this->SearchesLeft;
    this->Track(part, centerWorld);
    this->Search(part, centerWorld);
  }
  else if (isDue)
  {
    this->First = static_cast<std::size_t>(&group - this->Groups.data());
    if (part.WallCount == 0)
    {
      limits.Hold();
    }
  }
  return true;
}

template <typename Surface>
double OrganGaps<Surface>::GatherOf(Part& part, const Group& group, const ToolPose& pose,
                                    PoseConstraints& limits) noexcept
{
  const Vector3 center = pose.PositionWorld + pose.Orientation * part.Ball.Center;
  const bool isNear = this->LookAround(part, group, center, limits);
  const auto number = static_cast<std::size_t>(&part - this->Parts.data());
  for (std::size_t n = 0; isNear && n < part.WallCount; ++n)
  {
    const ClosestPoint& wall = part.Walls[n];
    this->AddWall(pose, part.Ball, number, {wall.Normal, GapAt(part, wall, center), n}, limits);
  }
  return UnknownAt(part, group, center);
}

template <typename Surface>
double OrganGaps<Surface>::Gather(const ToolPose& pose, PoseConstraints& limits) noexcept
{
  double nearest = std::numeric_limits<double>::max();
  for (std::size_t k = 0; k < this->Groups.size(); ++k)
  {
    Group& group = this->Groups[(this->First + k) % this->Groups.size()];
    const ToolSkeleton::Cluster& cluster = group.Cluster;
    const Vector3 center = pose.PositionWorld + pose.Orientation * cluster.Center;
    const double away = cluster.End - cluster.Begin > 1 ? this->LookAround(group, center) : 0.0;
    if (away >= RigidProxy::Margin)
    {
      nearest = std::min(nearest, away);
      continue;
    }
    for (std::size_t n = cluster.Begin; n < cluster.End; ++n)
    {
      nearest = std::min(nearest, this->GatherOf(this->Parts[n], group, pose, limits));
    }
  }
  return nearest;
}

// What is nearer to a free place than the surface is free too, so that most balls need no search.
// A ball that was inside is asked first: it is likely to be so still.
template <typename Surface>
bool OrganGaps<Surface>::IsFreeAt(const ToolPose& pose) noexcept
{
  ProvenBall free;
  for (std::size_t k = 0; k < this->Parts.size(); ++k)
  {
    const std::size_t number = (this->FirstAsked + k) % this->Parts.size();
    const ToolSkeleton::Ball& ball = this->Parts[number].Ball;
    const Vector3 center = pose.PositionWorld + pose.Orientation * ball.Center;
    if (free.DistanceAt(center) > ball.Radius)
    {
      continue;
    }
    const ClosestPoint found =
        this->Touched->SeenFrom(center, this->Touched->Search().Nearest(center));
    if (!(found.SignedDistance - ball.Radius > -Slack))
    {
      this->FirstAsked = number;
      return false;
    }
    free = {center, found.SignedDistance - found.DistanceError};
  }
  return true;
}

template class OrganGaps<TouchableRadialModel>;
template class OrganGaps<TouchableSurfaceModel>;
} // namespace palpate
