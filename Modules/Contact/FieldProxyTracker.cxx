#include "FieldProxyTracker.h"

#include "IcosahedronDirections.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// In voxels. Steps of the proxy and of its goal are short enough not to cross a wall one voxel
// thick; a contact point is kept while it is this near; and this distance counts as converged.
constexpr double LongestStep = 0.25;
constexpr double Watched = 0.5;
constexpr double FieldTolerance = 1e-3;
// rad; a sphere's contact point is then normal to the surface.
constexpr double Aligned = 1e-4;
// Limits of a tick.
constexpr int MostParts = 4;
constexpr int MostStrides = 16;
constexpr int MostSolves = 8;

// A sphere's points moved outwards: by the largest height of the sphere between them, and by a
// voxel for curved walls. None if the tool is no sphere, or its points are too sparse.
std::optional<ToolShell> HaloOf(const ToolShape& tool, double voxel)
{
  constexpr int Frequency = 12; // directions 4 degrees apart
  constexpr double LeastCover = 0.5;
  if (!tool.IsSphere() || !(tool.Radius() > 0.0))
  {
    return std::nullopt;
  }
  const IcosahedronDirections sphere(Frequency);
  double cover = 1.0;
  for (const Vector3& u : sphere.Directions())
  {
    double nearest = 0.0;
    for (const Vector3& inward : tool.Normals())
    {
      nearest = std::max(nearest, -u.dot(inward));
    }
    cover = std::min(cover, nearest);
  }
  const double radius = tool.Radius() / std::max(cover, LeastCover) + voxel;
  std::vector<Vector3> points;
  points.reserve(tool.Normals().size());
  for (const Vector3& inward : tool.Normals())
  {
    points.push_back(-radius * inward);
  }
  return ToolShell(ToolShape::FromSurfacePoints(std::move(points), tool.Normals()));
}
} // namespace

FieldProxyTracker::FieldProxyTracker(std::shared_ptr<const FieldSolid> solid, const ToolShape& tool,
                                     const SurfaceFriction& friction)
    : Solid(std::move(solid)), Shell(tool), Halo(HaloOf(tool, Solid->VoxelSize())),
      Friction(friction), Reach(tool.BoundingRadius()), SphereRadius(tool.Radius()),
      Feet(2 * Shell.Count()), HasFoot(Shell.Count(), 0), Planes(Feet.size())
{
}

std::size_t FieldProxyTracker::Bytes() const noexcept
{
  return sizeof(*this) + this->Shell.Bytes() + (this->Halo ? this->Halo->Bytes() : 0) +
         this->Feet.size() * sizeof(Foot) + this->HasFoot.size() +
         this->Planes.size() * sizeof(HalfSpace);
}

const Contact& FieldProxyTracker::Follow(const ToolPose& pose) noexcept
{
  if (!pose.IsUsable())
  {
    this->Felt = Contact();
    return this->Felt;
  }
  this->IsTurned = this->Shell.Turn(pose.Orientation);
  if (this->Halo)
  {
    this->Halo->Turn(pose.Orientation);
  }
  this->Advance(pose.PositionWorld);
  this->Report(pose.PositionWorld);
  return this->Felt;
}

void FieldProxyTracker::Advance(const Vector3& probe) noexcept
{
  if (this->Known == State::Nothing || this->IsLost)
  {
    this->Settle(probe);
    return;
  }
  for (int part = 0; part < MostParts; ++part)
  {
    if (this->Known == State::Free && this->MoveFree(probe))
    {
      return;
    }
    this->Slide(probe);
    if (this->Known == State::Touching)
    {
      return;
    }
  }
}

// Returns false on contact.
bool FieldProxyTracker::MoveFree(const Vector3& probe) noexcept
{
  const Eigen::AlignedBox3d box =
      Eigen::AlignedBox3d(this->ToolWorld.cwiseMin(probe), this->ToolWorld.cwiseMax(probe));
  const double square = this->Reach * this->Reach;
  if (box.squaredExteriorDistance(this->Solid->BoundsWorld()) > square)
  {
    this->ProbeWorld = this->ToolWorld = probe;
    return true;
  }
  const Vector3 path = probe - this->ToolWorld;
  const double part = path.norm() > LongestStep * this->Solid->VoxelSize()
                          ? this->Shell.PartToEntry(*this->Solid, this->ToolWorld, path)
                          : 1.0;
  if (part == 1.0 && this->Shell.CountInside(*this->Solid, probe) == 0)
  {
    const bool isTouching = this->TouchesBetweenPoints(probe);
    this->ProbeWorld = this->ToolWorld = probe;
    this->Known = isTouching ? State::Touching : State::Free;
    return !isTouching;
  }
  if (part < 1.0)
  {
    this->ToolWorld += part * path;
  }
  this->ProbeWorld = this->ToolWorld;
  this->Known = State::Touching;
  this->ForgetFeet();
  return false;
}

// Whether a sphere, none of whose points is inside, is inside between them. Its contact points are
// then set there.
bool FieldProxyTracker::TouchesBetweenPoints(const Vector3& probe) noexcept
{
  if (!this->Halo || this->Halo->CountInside(*this->Solid, probe) == 0)
  {
    return false;
  }
  this->ForgetFeet();
  for (std::size_t point = 0; point < this->Halo->Count(); ++point)
  {
    if (!this->Halo->IsInside(point))
    {
      continue;
    }
    FieldSolid::Wall wall =
        this->Solid->WallNear(probe + this->Halo->Offset(point), this->Halo->InwardNormal(point));
    constexpr int Moves = 4; // to where the sphere is deepest in the wall
    for (int move = 0; move < Moves && wall.IsKnown; ++move)
    {
      const Vector3 offset = -this->SphereRadius * wall.Normal;
      wall = this->Solid->WallNear(probe + offset, wall.Normal);
      if (move + 1 == Moves && wall.IsKnown && wall.Distance < 0.0)
      {
        this->Feet[this->FootCount++] = {offset, wall.Normal, point, true};
      }
    }
  }
  return this->FootCount > 0;
}

// Without a known position: at the nearest possible place to the probe.
void FieldProxyTracker::Settle(const Vector3& probe) noexcept
{
  this->IsLost = false;
  this->ProbeWorld = this->ToolWorld = probe;
  this->ForgetFeet();
  const int inside = this->Shell.CountInside(*this->Solid, probe);
  this->Known = inside == 0 ? State::Free : State::Touching;
  if (inside == 0)
  {
    return;
  }
  this->AddFeet();
  this->GatherPlanes();
  if (this->FootCount < static_cast<std::size_t>(inside))
  {
    this->Escape(probe);
  }
  for (int more = 0; more < MostStrides && this->Known == State::Touching; ++more)
  {
    this->Slide(probe);
    if (this->Deepest <= FieldTolerance * this->Solid->VoxelSize())
    {
      break;
    }
  }
}

// Moves out by the shortest path along which the tool's origin leaves the solid and the tool is
// free; stays in place if there is none.
void FieldProxyTracker::Escape(const Vector3& probe) noexcept
{
  double shortest = this->Solid->BoundsWorld().diagonal().norm();
  for (std::size_t i = 0; i < this->Shell.Count(); ++i)
  {
    const Vector3 outward = -this->Shell.InwardNormal(i);
    const double length = this->Solid->DistanceToExit(probe, outward, shortest);
    const Vector3 place = probe + (length + this->Reach) * outward;
    if (length < shortest && this->Shell.CountInside(*this->Solid, place) == 0)
    {
      shortest = length;
      this->ToolWorld = place;
    }
  }
}

// Along the probe's path in short steps, until contact ends or the end is reached.
void FieldProxyTracker::Slide(const Vector3& probe) noexcept
{
  const Vector3 start = this->ProbeWorld;
  const Vector3 path = probe - start;
  const double wanted = path.norm() / (LongestStep * this->Solid->VoxelSize());
  const int strides = 1 + static_cast<int>(std::min(wanted, MostStrides - 1.0));
  for (int i = 1; i <= strides; ++i)
  {
    this->ProbeWorld = i == strides ? probe : Vector3(start + (1.0 * i / strides) * path);
    if (!this->Press(this->ProbeWorld))
    {
      this->Known = State::Free;
      return;
    }
  }
}

// One short step of the probe, with friction; returns false if contact ends.
bool FieldProxyTracker::Press(const Vector3& goal) noexcept
{
  if (this->FootCount == 0)
  {
    return this->Solve(goal) && this->Solve(goal); // the second one moves the contact points
  }
  const FrictionCone::Pull pull(goal - this->ToolWorld, this->NormalWorld);
  if (!this->Friction.IsFrictionless() && this->Friction.Sticks(pull) && !this->IsTurned)
  {
    return true;
  }
  return this->Solve(this->Friction.DrawnTo(goal, this->ToolWorld, this->NormalWorld));
}

// Moves the proxy as near to the goal as the field allows; returns false if nothing is in the way.
bool FieldProxyTracker::Solve(const Vector3& goal) noexcept
{
  const double voxel = this->Solid->VoxelSize();
  this->MoveFeet();
  for (int solve = 0; solve < MostSolves; ++solve)
  {
    const int inside = this->Shell.CountInside(*this->Solid, this->ToolWorld);
    if (inside > 0)
    {
      this->AddFeet();
    }
    this->GatherPlanes();
    this->IsLost = inside > 0 && this->FootCount == 0;
    if (this->IsLost)
    {
      break;
    }
    const NearestHeld held = NearestInHalfSpaces(goal, this->Planes.data(), this->FootCount);
    if (!held.IsHeld)
    {
      break;
    }
    const Vector3 step = held.Point - this->ToolWorld;
    const double length = step.norm();
    const bool isThere = length <= FieldTolerance * voxel;
    const Vector3 push = held.Point - goal;
    if (push.squaredNorm() > 0.0)
    {
      this->NormalWorld = push.normalized();
    }
    else if (this->Deepest <= FieldTolerance * voxel &&
             (isThere || (solve > 0 && this->FootCount == 0)))
    {
      return false;
    }
    this->ToolWorld += std::min(1.0, LongestStep * voxel / length) * step;
    if (isThere)
    {
      return true;
    }
  }
  this->Surface();
  return true;
}

// If the steps did not suffice to get near the goal: at least onto the surface, by the shortest
// path.
void FieldProxyTracker::Surface() noexcept
{
  constexpr int Steps = 2;
  for (int step = 0; step < Steps; ++step)
  {
    if (this->Shell.CountInside(*this->Solid, this->ToolWorld) > 0)
    {
      this->AddFeet();
    }
    this->GatherPlanes();
    const NearestHeld held =
        NearestInHalfSpaces(this->ToolWorld, this->Planes.data(), this->FootCount);
    const Vector3 path = held.Point - this->ToolWorld;
    const double longest = LongestStep * this->Solid->VoxelSize();
    this->ToolWorld += std::min(1.0, longest / path.norm()) * path;
  }
}

void FieldProxyTracker::ForgetFeet() noexcept
{
  this->FootCount = 0;
  std::fill(this->HasFoot.begin(), this->HasFoot.end(), 0);
}

void FieldProxyTracker::LiftFoot(std::size_t foot) noexcept
{
  if (!this->Feet[foot].HasMoved)
  {
    this->HasFoot[this->Feet[foot].Point] = 0;
  }
  this->Feet[foot] = this->Feet[--this->FootCount];
}

// Once per step of the goal, so that planes do not move during the search between them. Contact
// points that meet are merged.
void FieldProxyTracker::MoveFeet() noexcept
{
  const double together = 0.01 * this->SphereRadius;
  for (std::size_t i = this->FootCount; i-- > 0;)
  {
    Foot& foot = this->Feet[i];
    if (!(this->SphereRadius > 0.0))
    {
      foot.Offset = this->Shell.Offset(foot.Point);
      continue;
    }
    this->MoveOnSphere(foot);
    for (std::size_t other = i + 1; other < this->FootCount; ++other)
    {
      if ((this->Feet[other].Offset - foot.Offset).squaredNorm() <= together * together)
      {
        this->LiftFoot(i);
        break;
      }
    }
  }
}

// Towards where the sphere is deepest in the last plane, as far as the depth increases: not on
// edges, and only half as far on surfaces that curve away as much as the sphere. The shell point
// from which the contact point started may then get another one.
void FieldProxyTracker::MoveOnSphere(Foot& foot) noexcept
{
  const Vector3 from = foot.Offset / this->SphereRadius;
  if ((from + foot.Normal).squaredNorm() <= Aligned * Aligned)
  {
    return;
  }
  const FieldSolid::Wall here = this->Solid->WallNear(this->ToolWorld + foot.Offset, foot.Normal);
  for (const double part : {1.0, 0.5, 0.25})
  {
    const Vector3 to = (1.0 - part) * from - part * foot.Normal;
    const Vector3 offset = this->SphereRadius * to.normalized();
    const FieldSolid::Wall there = this->Solid->WallNear(this->ToolWorld + offset, foot.Normal);
    if (there.IsKnown && there.Distance < here.Distance)
    {
      foot.Offset = offset;
      this->HasFoot[foot.Point] = foot.HasMoved ? this->HasFoot[foot.Point] : 0;
      foot.HasMoved = true;
      return;
    }
  }
}

// For every inside point that has none.
void FieldProxyTracker::AddFeet() noexcept
{
  for (std::size_t point = 0; point < this->Shell.Count(); ++point)
  {
    if (this->Shell.IsInside(point) && this->HasFoot[point] == 0 &&
        this->FootCount < this->Feet.size())
    {
      this->HasFoot[point] = 1;
      // Until more is known, the outward direction is that of the tool's inward normal.
      this->Feet[this->FootCount++] = {this->Shell.Offset(point), this->Shell.InwardNormal(point),
                                       point, false};
    }
  }
}

// Contact points that are lost, or no longer near the surface, are removed.
void FieldProxyTracker::GatherPlanes() noexcept
{
  const double watched = Watched * this->Solid->VoxelSize();
  this->Deepest = 0.0;
  for (std::size_t i = this->FootCount; i-- > 0;)
  {
    Foot& foot = this->Feet[i];
    const FieldSolid::Wall wall = this->Solid->WallNear(this->ToolWorld + foot.Offset, foot.Normal);
    if (!wall.IsKnown || wall.Distance > watched)
    {
      this->LiftFoot(i);
      this->Planes[i] = this->Planes[this->FootCount];
      continue;
    }
    foot.Normal = wall.Normal;
    this->Planes[i] = {wall.Normal, wall.Normal.dot(this->ToolWorld) - wall.Distance};
    this->Deepest = std::max(this->Deepest, -wall.Distance);
  }
}

void FieldProxyTracker::Report(const Vector3& probe) noexcept
{
  this->Felt.IsValid = true;
  this->Felt.IsTouching = this->Known == State::Touching;
  this->Felt.Material = this->Solid->Material();
  this->Felt.ProxyWorld = this->Felt.IsTouching ? this->ToolWorld : probe;
  this->Felt.NormalWorld = this->NormalWorld;
  this->Felt.Depth = (this->Felt.ProxyWorld - probe).norm();
}
} // namespace palpate
