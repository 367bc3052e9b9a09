#include "FacetTracker.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// Limits of a tick: rounds, and planes per round.
constexpr int MostRounds = 4;
constexpr std::size_t MostPlanes = 4;
// Share of the skin that noise of the mesh's coordinates, which are often of single precision, may
// take.
constexpr double GrazedSkin = 0.25;
// Skins; a lag by that noise that no hand feels is left as it is, so that sessions that were
// recorded before it was removed replay with the same bits.
constexpr double UnfeltLag = 100.0;
// A round that changes the pull by less is the last one.
constexpr double FacetTolerance = 1e-3;
} // namespace

FacetTracker::FacetTracker(std::shared_ptr<const FacetTree> tree, double toolRadius,
                           const SurfaceFriction& friction)
    : Tree(std::move(tree)), ToolRadius(toolRadius),
      Skin(1e-6 * (Tree->BoundsWorld().diagonal().norm() + toolRadius)), Friction(friction)
{
}

const Contact& FacetTracker::Follow(const ToolPose& pose) noexcept
{
  if (!pose.IsUsable())
  {
    this->Felt = Contact();
    return this->Felt;
  }
  const Vector3& probe = pose.PositionWorld;
  if (this->IsKnown)
  {
    this->Advance(probe);
  }
  else
  {
    this->Settle(probe);
  }
  this->Felt.IsValid = true;
  this->Felt.IsTouching = this->IsTouching;
  this->Felt.ProxyWorld = this->IsTouching ? this->ProxyWorld : probe;
  this->Felt.NormalWorld = this->NormalWorld;
  this->Felt.Depth = (this->Felt.ProxyWorld - probe).norm();
  return this->Felt;
}

bool FacetTracker::IsFreeAt(const ToolPose& pose) noexcept
{
  const Vector3& place = pose.PositionWorld;
  return pose.IsUsable() && !this->Tree->IsInside(place) &&
         !(this->Tree->NearestTo(place, this->ToolRadius).Distance <= this->ToolRadius);
}

// Without a known position: next to the nearest point, outside the mesh.
void FacetTracker::Settle(const Vector3& probe) noexcept
{
  this->IsKnown = true;
  this->IsTouching = false;
  this->ProxyWorld = probe;
  const bool isInside = this->Tree->IsInside(probe);
  const double distance = this->ToolRadius + this->Skin;
  const double within = isInside ? std::numeric_limits<double>::infinity() : distance;
  const FacetTree::Nearest nearest = this->Tree->NearestTo(probe, within);
  if (nearest.Distance <= within)
  {
    const Vector3 offset = isInside ? nearest.PointWorld - probe : probe - nearest.PointWorld;
    this->IsTouching = true;
    this->NormalWorld = offset.squaredNorm() > 0.0 ? offset.normalized() : this->NormalWorld;
    this->ProxyWorld = nearest.PointWorld + distance * this->NormalWorld;
  }
}

void FacetTracker::Advance(const Vector3& probe) noexcept
{
  const Vector3 drawnTo =
      this->IsTouching ? this->Friction.DrawnTo(probe, this->ProxyWorld, this->NormalWorld) : probe;
  if (!this->Slide(drawnTo, probe, 0.0))
  {
    this->SlideOverNoise(drawnTo, probe);
  }
  // Planes may have moved the proxy off the mesh with no rounds left to return along others.
  if (this->IsTouching && !this->IsInReach())
  {
    this->IsTouching = this->MoveTo(drawnTo, 1, 0.0) > 0 && this->IsInReach();
  }
}

// In rounds, until one changes little. Returns false if the last one used up its planes.
bool FacetTracker::Slide(const Vector3& goal, const Vector3& probe, double slack) noexcept
{
  std::size_t planes = 0;
  for (int round = 0; round < MostRounds; ++round)
  {
    const Vector3 before = this->ProxyWorld;
    planes = this->MoveTo(goal, MostPlanes, slack);
    this->IsTouching = planes > 0;
    const double left = FacetTolerance * (probe - this->ProxyWorld).norm();
    if (!this->IsTouching || (this->ProxyWorld - before).norm() <= std::max(this->Skin, left))
    {
      break;
    }
  }
  return planes < MostPlanes;
}

// Where planes are used up by noise of the mesh's coordinates, the tool lags behind.
void FacetTracker::SlideOverNoise(const Vector3& goal, const Vector3& probe) noexcept
{
  const Vector3 place = this->ProxyWorld;
  const Vector3 normal = this->NormalWorld;
  this->Slide(goal, probe, GrazedSkin * this->Skin);
  if ((this->ProxyWorld - place).norm() <= UnfeltLag * this->Skin)
  {
    this->ProxyWorld = place;
    this->NormalWorld = normal;
    this->IsTouching = true;
  }
}

bool FacetTracker::IsInReach() const noexcept
{
  const double reach = this->ToolRadius + 2.0 * this->Skin;
  return this->Tree->BoundsWorld().squaredExteriorDistance(this->ProxyWorld) <= reach * reach;
}

// As near to the goal as planes touched along the path allow; returns their number, 0 if it was
// reached without contact. `slack` is SphereMotion's, mm.
std::size_t FacetTracker::MoveTo(const Vector3& goal, std::size_t mostPlanes, double slack) noexcept
{
  std::array<HalfSpace, MostPlanes> planes;
  std::size_t count = 0;
  Vector3 target = goal;
  while (count < mostPlanes)
  {
    const Vector3 path = target - this->ProxyWorld;
    const SweepHit hit =
        this->Tree->Sweep({this->ProxyWorld, path, this->ToolRadius + this->Skin, slack});
    this->ProxyWorld = hit.IsHit ? Vector3(this->ProxyWorld + hit.Part * path) : target;
    if (!hit.IsHit)
    {
      break;
    }
    planes[count++] = {hit.Normal, hit.Normal.dot(this->ProxyWorld) + hit.Overlap};
    const NearestHeld held = NearestInHalfSpaces(goal, planes.data(), count);
    if (!held.IsHeld)
    {
      return mostPlanes; // almost parallel ones, for which no more would help
    }
    target = held.Point;
    const Vector3 push = target - goal;
    this->NormalWorld = push.squaredNorm() > 0.0 ? push.normalized() : this->NormalWorld;
  }
  return count;
}
} // namespace palpate
