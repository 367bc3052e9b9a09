#include "NearestPointTracker.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
namespace
{
// Relative to the smallest radius, so that units do not matter. The gap is far below what a hand or
// an encoder resolves; the stride keeps Newton's method in the basin of its minimum.
constexpr double RelativeGap = 1e-6;
constexpr double RelativeStride = 1.0 / 16.0;
// How high above the surface it is known which place is the nearest.
constexpr double RelativeReach = 0.25;
// Limits of a tick: steps through free space, and short steps of a probe in contact.
constexpr int MostPartsOfMove = 4;
constexpr int MostFreeSteps = 16;
constexpr int MostStridesOfMove = 32;
// Of a search of the whole surface, and where the work of a tick has ended. Rough bodies need many.
constexpr int EvaluationsOfSearch = 256;
constexpr int FewEvaluations = 20;

// How far (rad) a proxy may turn about the centre while the probe moves by `motion` times the
// smallest radius: more than it needs to follow a minimum, except close to the medial axis, where
// it must not jump.
double LargestTurn(double motion) noexcept
{
  return std::min(0.5, 0.1 + 2.0 * motion);
}

// Rotates a unit vector by `angle` (rad) towards another; in any direction towards the opposite
// one.
Vector3 Turned(const Vector3& from, const Vector3& to, double angle) noexcept
{
  const Vector3 across = to - to.dot(from) * from;
  const double length = across.norm();
  const Vector3 side = length > 1e-6 ? Vector3(across / length) : from.unitOrthogonal();
  return (std::cos(angle) * from + std::sin(angle) * side).normalized();
}

template <typename Surface>
typename Surface::Place PlaceOf(const typename Surface::ClosestPoint& point) noexcept
{
  return {point.Direction, point.PointWorld, point.Normal};
}
} // namespace

template <typename Surface>
NearestPointTrackerOf<Surface>::NearestPointTrackerOf(std::shared_ptr<const Surface> surface,
                                                      double toolRadius,
                                                      const SurfaceFriction& friction,
                                                      double wallsAhead)
    : Touched(std::move(surface)), ToolRadius(toolRadius), Friction(friction),
      TouchingGap(
          std::max(RelativeGap * this->Touched->SmallestRadius(), 2.0 * this->Touched->Rounding())),
      Stride(RelativeStride * this->Touched->SmallestRadius())
{
  bool isWedgeNeeded = false;
  if constexpr (Surface::MayCrossItself)
  {
    this->Places =
        this->Touched->PlacesFor(toolRadius, RelativeReach * this->Touched->SmallestRadius());
    isWedgeNeeded = !this->Places->IsEmpty();
  }
  else
  {
    isWedgeNeeded = ContactWedgeOf<Surface>::IsNeeded(*this->Touched, toolRadius);
  }
  if (isWedgeNeeded)
  {
    this->Wedge = std::make_unique<ContactWedgeOf<Surface>>(
        this->Touched, toolRadius + this->Touched->Margin(), wallsAhead);
  }
  if constexpr (Surface::MayCrossItself)
  {
    this->Motion = std::make_unique<ClearMotion>(*this->Touched, *this->Places, toolRadius,
                                                 this->Stride, this->TouchingGap,
                                                 this->Wedge ? this->Wedge->Clearance() : nullptr);
  }
}

template <typename Surface>
const Contact& NearestPointTrackerOf<Surface>::Follow(const ToolPose& pose) noexcept
{
  if (!pose.IsUsable())
  {
    this->Felt = Contact();
    return this->Felt;
  }
  this->EvaluationsLeft = this->Touched->EvaluationsOfTick();
  this->Advance(pose.PositionWorld);
  if (this->IsWedging && this->Known == State::Touching)
  {
    this->DragWedge(pose.PositionWorld);
    this->Wedge->LookAhead();
    this->IsHovering = !this->Wedge->IsHeld();
    this->EndWedge(pose.PositionWorld);
  }
  this->Report(pose.PositionWorld);
  return this->Felt;
}

template <typename Surface>
bool NearestPointTrackerOf<Surface>::IsFreeAt(const ToolPose& pose) noexcept
{
  if (!pose.IsUsable())
  {
    return false;
  }
  const Vector3& place = pose.PositionWorld;
  const ClosestPoint nearest = this->Touched->Search().Nearest(place, EvaluationsOfSearch);
  return this->Touched->SeenFrom(place, nearest).SignedDistance >= this->EndOfContact();
}

template <typename Surface>
int NearestPointTrackerOf<Surface>::EvaluationsOfNextSearch() const noexcept
{
  return std::clamp(this->EvaluationsLeft, FewEvaluations, EvaluationsOfSearch);
}

template <typename Surface>
typename NearestPointTrackerOf<Surface>::ClosestPoint
NearestPointTrackerOf<Surface>::NearestTo(const Vector3& probe) noexcept
{
  const auto& search = this->Touched->Search();
  const int most = this->EvaluationsOfNextSearch();
  ClosestPoint nearest = this->IsNearKnown() ? search.Nearest(probe, most, this->Closest)
                                             : search.Nearest(probe, most);
  this->EvaluationsLeft -= nearest.Evaluations;
  return nearest;
}

// Follows the probe's path from its last place. Work beyond a tick's limits is left to the next.
template <typename Surface>
void NearestPointTrackerOf<Surface>::Advance(const Vector3& probe) noexcept
{
  if (this->Known == State::Nothing)
  {
    this->Settle(probe);
    return;
  }
  for (int part = 0; part < MostPartsOfMove; ++part)
  {
    if (this->Known == State::Free && this->MoveFree(probe))
    {
      return;
    }
    if (Surface::MayCrossItself && this->IsWedging)
    {
      return; // the wedge follows alone
    }
    this->Slide(probe);
    if (this->Known == State::Touching)
    {
      return;
    }
  }
}

// From sphere to sphere along the path (Hart, "Sphere tracing", The Visual Computer 12, 1996).
// Returns false on contact.
template <typename Surface>
bool NearestPointTrackerOf<Surface>::MoveFree(const Vector3& probe) noexcept
{
  if constexpr (Surface::MayCrossItself)
  {
    const bool isFree = this->Motion->MoveTo(probe, this->EvaluationsLeft);
    this->EvaluationsLeft = this->Motion->Left();
    this->ProbeWorld = this->Motion->PlaceWorld();
    if (!isFree)
    {
      this->Touch(this->Motion->Met(), this->Motion->FreeBefore());
    }
    return isFree;
  }
  else
  {
    for (int step = 0; step < MostFreeSteps; ++step)
    {
      if ((probe - this->ClearCenterWorld).norm() <= this->ClearRadius)
      {
        this->ProbeWorld = probe;
        return true;
      }
      this->Measure(this->ProbeWorld);
      if (this->ClearRadius <= this->TouchingGap)
      {
        break;
      }
      const Vector3 path = probe - this->ProbeWorld;
      const double length = path.norm();
      this->ProbeWorld += std::min(1.0, this->ClearRadius / length) * path;
    }
    this->Touch(this->NearestTo(this->ProbeWorld));
    return false;
  }
}

// Computes the free sphere around a place of the probe. Far away the sphere around the surface
// suffices.
template <typename Surface>
void NearestPointTrackerOf<Surface>::Measure(const Vector3& probe) noexcept
{
  const double largest = this->Touched->LargestRadius();
  const double centerDistance = (probe - this->Touched->Model().CenterWorld()).norm();
  this->ClearCenterWorld = probe;
  this->ClearRadius = centerDistance - largest - this->ToolRadius;
  if (this->ClearRadius <= 0.25 * largest)
  {
    const ClosestPoint closest =
        this->Touched->Search().Clearance(probe, this->ToolRadius, this->EvaluationsOfNextSearch());
    this->EvaluationsLeft -= closest.Evaluations;
    this->ClearRadius = closest.SignedDistance - closest.DistanceError - this->ToolRadius;
  }
}

template <typename Surface>
void NearestPointTrackerOf<Surface>::Settle(const Vector3& probe) noexcept
{
  const ClosestPoint nearest = this->Touched->SeenFrom(probe, this->NearestTo(probe));
  this->ProbeWorld = probe;
  if (nearest.SignedDistance < this->EndOfContact())
  {
    this->Touch(nearest);
  }
  else
  {
    this->LetGo(nearest);
  }
}

template <typename Surface>
void NearestPointTrackerOf<Surface>::Touch(const ClosestPoint& nearest,
                                           const ProvenBall& known) noexcept
{
  this->Known = State::Touching;
  this->IsHovering = false;
  this->Closest = nearest;
  this->Held = PlaceOf<Surface>(nearest);
  this->IsWedging = this->NeedsWedge(nearest.Direction);
  if (this->IsWedging)
  {
    this->Wedge->Begin(nearest, known);
  }
}

template <typename Surface>
void NearestPointTrackerOf<Surface>::LetGo(const ClosestPoint& nearest) noexcept
{
  this->Known = State::Free;
  if constexpr (Surface::MayCrossItself)
  {
    this->Motion->Begin(this->ProbeWorld, nearest);
  }
  else
  {
    this->ClearCenterWorld = this->ProbeWorld;
    this->ClearRadius = nearest.SignedDistance - nearest.DistanceError - this->ToolRadius;
  }
}

// Where a surface crosses itself, contact may have brought a tool into its other part. There it is
// not free, but settles as at its start: else it would feel nothing inside, and walls from their
// inner sides.
template <typename Surface>
void NearestPointTrackerOf<Surface>::LetGoOutside(const ClosestPoint& nearest,
                                                  const Vector3& probe) noexcept
{
  if (!this->Touched->CrossesItself() || this->Touched->IsOutside(this->ProbeWorld, nearest))
  {
    this->LetGo(nearest);
  }
  else
  {
    this->Settle(probe);
  }
}

// Along the path in short steps, until contact ends or the end is reached.
template <typename Surface>
void NearestPointTrackerOf<Surface>::Slide(const Vector3& probe) noexcept
{
  const Vector3 start = this->ProbeWorld;
  const Vector3 path = probe - start;
  const double length = path.norm();
  const int strides =
      1 + static_cast<int>(std::min(length / this->Stride, MostStridesOfMove - 1.0));
  const auto mayGoOn = [&] { return !Surface::CountsAllWork || this->EvaluationsLeft > 0; };
  for (int i = 1; i <= strides && (i == 1 || mayGoOn()); ++i)
  {
    const Vector3 next = i == strides ? probe : Vector3(start + (1.0 * i / strides) * path);
    const ProvenBall before = this->RoomOfOneWall();
    if (!this->Press(next, length / strides))
    {
      return;
    }
    if (Surface::MayCrossItself && this->NeedsWedge(this->Held.Direction))
    {
      this->Wedge->Begin(
          this->Touched->PointAt(this->Held.Direction, this->ProbeWorld, this->Closest), before);
      this->IsWedging = true;
      return;
    }
  }
}

// Where a single wall holds a tool that fits there, nothing is in most of the tool. WedgePlaces
// knows that by trials, and only of the outer side.
template <typename Surface>
ProvenBall NearestPointTrackerOf<Surface>::RoomOfOneWall() const noexcept
{
  constexpr double Most = 0.9;
  if (this->Touched->CrossesItself())
  {
    return {};
  }
  return {this->Held.PointWorld + this->ToolRadius * this->Held.Normal, Most * this->ToolRadius};
}

// One short step in contact; returns false if contact ends.
template <typename Surface>
bool NearestPointTrackerOf<Surface>::Press(const Vector3& probe, double motion) noexcept
{
  const Vector3 start = std::exchange(this->ProbeWorld, probe);
  const ClosestPoint next = this->Continued(start, probe);
  if (next.SignedDistance >= this->EndOfContact())
  {
    this->Leave(next, probe);
    return false;
  }
  const double largestTurn = LargestTurn(motion / this->Touched->SmallestRadius());
  const Vector3& last = this->Closest.Direction;
  const bool isNear = (next.Direction - last).squaredNorm() <= largestTurn * largestTurn;
  this->Closest = isNear ? next
                         : this->Touched->PointAt(Turned(last, next.Direction, largestTurn), probe,
                                                  this->Closest);
  this->Drag(probe);
  return true;
}

// At a surface model free motion goes on from a little above the surface, so that what it may
// cross is found.
template <typename Surface>
void NearestPointTrackerOf<Surface>::Leave(const ClosestPoint& next, const Vector3& probe) noexcept
{
  if constexpr (Surface::MayCrossItself)
  {
    this->ProbeWorld = next.PointWorld + (this->ToolRadius + 4.0 * this->TouchingGap) * next.Normal;
    this->LetGoOutside(this->Touched->Search().Track(this->ProbeWorld, next), probe);
  }
  else
  {
    this->LetGo(next);
  }
}

// A minimum that is about to end moves many times as fast as the probe, and takes more steps, since
// a descent from far away may end in another one.
template <typename Surface>
typename NearestPointTrackerOf<Surface>::ClosestPoint
NearestPointTrackerOf<Surface>::Tracked(const Vector3& start, const Vector3& probe) noexcept
{
  const auto track = [&](const Vector3& place, const ClosestPoint& last)
  {
    const ClosestPoint tracked = this->Touched->Search().Track(place, last);
    this->EvaluationsLeft -= Surface::CountsAllWork ? tracked.Evaluations : 0;
    return tracked;
  };
  const ClosestPoint next = track(probe, this->Closest);
  if constexpr (Surface::MayCrossItself)
  {
    constexpr int Parts = 16;
    const Vector3 path = probe - start;
    if (this->IsContinued(this->Closest, next, path.norm()))
    {
      return next;
    }
    ClosestPoint followed = this->Closest;
    bool isFollowed = followed.Converged();
    for (int part = 1; part <= Parts && isFollowed; ++part)
    {
      const ClosestPoint last = followed;
      followed = track(start + (1.0 * part / Parts) * path, last);
      isFollowed = this->IsContinued(last, followed, path.norm() / Parts);
    }
    return isFollowed                                   ? followed
           : next.State == ClosestPoint::Outcome::Limit ? track(probe, next)
                                                        : next;
  }
  return next;
}

// Whether this is the same minimum after the probe's motion (mm), and not one that took its place.
template <typename Surface>
bool NearestPointTrackerOf<Surface>::IsContinued(const ClosestPoint& last, const ClosestPoint& next,
                                                 double motion) const noexcept
{
  constexpr double Faster = 8.0;
  return next.Converged() &&
         (next.PointWorld - last.PointWorld).norm() <= Faster * motion + this->TouchingGap;
}

// The continued minimum; or another one, if contact with it has ended but not with the whole
// surface, or if it has become a saddle or a maximum that descent would never leave.
template <typename Surface>
typename NearestPointTrackerOf<Surface>::ClosestPoint
NearestPointTrackerOf<Surface>::Continued(const Vector3& start, const Vector3& probe) noexcept
{
  const ClosestPoint next = this->Tracked(start, probe);
  const bool isStationary =
      next.State == ClosestPoint::Outcome::Stationary && !next.Expansion.IsConvex();
  if ((Surface::MayCrossItself || next.SignedDistance < this->ToolRadius) && !isStationary)
  {
    return next;
  }
  const ClosestPoint nearest = this->NearestTo(probe);
  // At the centre of a sphere all directions are equal: then it is kept.
  constexpr double Nearer = 1.0 - 1e-6;
  const bool isNearer = std::abs(nearest.SignedDistance) < Nearer * std::abs(next.SignedDistance);
  return isStationary && !isNearer ? next : this->Touched->SeenLike(next, nearest);
}

// Applies friction to the held place.
template <typename Surface>
void NearestPointTrackerOf<Surface>::Drag(const Vector3& probe) noexcept
{
  if (this->Friction.IsFrictionless())
  {
    this->Held = PlaceOf<Surface>(this->Closest);
  }
  else if (!this->Friction.Sticks(this->PullOf(probe, this->Held)))
  {
    this->Held = this->Slip(probe, PlaceOf<Surface>(this->Closest));
  }
}

// Once per tick: it takes short steps itself.
template <typename Surface>
void NearestPointTrackerOf<Surface>::DragWedge(const Vector3& probe) noexcept
{
  const Vector3& held = this->Wedge->CenterWorld();
  const Vector3& normal = this->Wedge->Normal();
  const bool sticks = !this->IsHovering && !this->Friction.IsFrictionless() &&
                      this->Friction.Sticks(FrictionCone::Pull(probe - held, normal));
  const Vector3 goal = this->IsHovering ? probe : this->Friction.DrawnTo(probe, held, normal);
  if constexpr (Surface::CountsAllWork)
  {
    if (!sticks || !this->Wedge->HasArrived())
    {
      this->Wedge->MoveTo(goal, this->EvaluationsLeft);
      this->EvaluationsLeft = this->Wedge->Left();
    }
  }
  else if (!sticks)
  {
    this->Wedge->MoveTo(goal);
  }
}

// A tool that no wall holds is free; where it fits, one that a single wall holds is followed by its
// nearest point again.
template <typename Surface>
void NearestPointTrackerOf<Surface>::EndWedge(const Vector3& probe) noexcept
{
  if (this->IsHovering && !this->IsBesideWall(probe))
  {
    this->LeaveWedge(probe);
  }
  else if constexpr (Surface::MayCrossItself)
  {
    const ClosestPoint* wall = this->Wedge->OnlyWall();
    if (this->IsHovering || wall == nullptr || this->Places->IsBeside(wall->Direction))
    {
      return;
    }
    const ClosestPoint next = this->Touched->Search().Track(probe, *wall);
    const double depth = (probe - this->Wedge->CenterWorld()).norm();
    if (next.Converged() && next.SignedDistance < this->ToolRadius &&
        (next.PointWorld - wall->PointWorld).norm() < depth + this->Wedge->Step())
    {
      this->Held = PlaceOf<Surface>(*wall);
      this->Closest = next;
      this->ProbeWorld = probe;
      this->IsWedging = false;
    }
  }
}

// Beside a wall of a surface model the wedge follows a tool that is free, too: with the next
// walls known, that is shorter than searches.
template <typename Surface>
bool NearestPointTrackerOf<Surface>::IsBesideWall(const Vector3& probe) const noexcept
{
  constexpr double Near = 0.5;
  if constexpr (Surface::MayCrossItself)
  {
    const ClosestPoint* wall = this->Wedge->NearestWall();
    return wall != nullptr &&
           wall->SignedDistance < this->RadiusAt(wall->Direction) + Near * this->Wedge->Step() &&
           (this->Wedge->CenterWorld() - probe).norm() <= this->TouchingGap;
  }
  else
  {
    return false;
  }
}

// A sphere that no wall holds is free, and moves from its place to the probe.
template <typename Surface>
void NearestPointTrackerOf<Surface>::LeaveWedge(const Vector3& probe) noexcept
{
  this->IsHovering = false;
  this->IsWedging = false;
  this->ProbeWorld = this->Wedge->CenterWorld();
  if constexpr (Surface::MayCrossItself)
  {
    const ClosestPoint* wall = this->Wedge->NearestWall();
    this->LetGoOutside(wall != nullptr ? *wall : this->Closest, probe);
  }
  else
  {
    this->Known = State::Free;
    this->ClearCenterWorld = this->ProbeWorld;
    this->ClearRadius = 0.0;
  }
  this->Advance(probe);
}

// To where on the path to `end` the tool sticks again.
template <typename Surface>
typename Surface::Place NearestPointTrackerOf<Surface>::Slip(const Vector3& probe,
                                                             const Place& end) const noexcept
{
  Place place = end;
  const auto pullAt = [&](double part)
  {
    const Vector3 between = (1.0 - part) * this->Held.Direction + part * end.Direction;
    place = this->Touched->PlaceAt(between.normalized(), this->Closest);
    return this->PullOf(probe, place);
  };
  this->Friction.FindRest(this->PullOf(probe, this->Held), this->PullOf(probe, end), pullAt);
  return place;
}

template <typename Surface>
void NearestPointTrackerOf<Surface>::Report(const Vector3& probe) noexcept
{
  this->Felt.IsValid = true;
  this->Felt.IsTouching = this->Known == State::Touching;
  this->Felt.ProxyWorld = probe;
  this->Felt.Depth = 0.0;
  if (this->Felt.IsTouching)
  {
    this->Felt.NormalWorld = this->IsWedging ? this->Wedge->Normal() : this->Held.Normal;
    this->Felt.ProxyWorld =
        this->IsWedging ? this->Wedge->CenterWorld()
                        : Vector3(this->Held.PointWorld + this->ToolRadius * this->Held.Normal);
    this->Felt.Depth = (probe - this->Felt.ProxyWorld).norm();
    this->WithoutMargin(probe);
  }
  if constexpr (Surface::CountsAllWork)
  {
    this->Felt.IsBehind = this->Known == State::Touching && this->IsWedging
                              ? !this->Wedge->HasArrived()
                              : this->ProbeWorld != probe;
  }
}

// The proxy of the tool itself; without contact while only the margin or the gap is touched.
template <typename Surface>
void NearestPointTrackerOf<Surface>::WithoutMargin(const Vector3& probe) noexcept
{
  if constexpr (Surface::MayCrossItself)
  {
    const double margin = this->IsWedging ? this->Touched->Margin() : 0.0;
    this->Felt.ProxyWorld -= margin * this->Felt.NormalWorld;
    const Vector3 push = this->Felt.ProxyWorld - probe;
    const bool isHeld =
        !this->IsHovering && (push.dot(this->Felt.NormalWorld) > 0.0 || push.norm() > 2.0 * margin);
    this->Felt.IsTouching =
        this->IsWedging ? isHeld : this->Closest.SignedDistance < this->ToolRadius;
    this->Felt.ProxyWorld = this->Felt.IsTouching ? this->Felt.ProxyWorld : probe;
    this->Felt.Depth = this->Felt.IsTouching ? push.norm() : 0.0;
  }
}

template class NearestPointTrackerOf<TouchableRadialModel>;
template class NearestPointTrackerOf<TouchableSurfaceModel>;
} // namespace palpate
