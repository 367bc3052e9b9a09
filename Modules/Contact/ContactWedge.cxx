#include "ContactWedge.h"

#include "IcosahedronDirections.h"
#include "SlideRelaxation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
// A wall's minimum for another query on its normal: it is the same point.
template <typename ClosestPoint>
ClosestPoint SeenFrom(const Vector3& queryWorld, const Vector3& modelCenterWorld,
                      const ClosestPoint& wall) noexcept
{
  ClosestPoint seen = wall;
  seen.SignedDistance = (queryWorld - wall.PointWorld).dot(wall.Normal);
  seen.Expansion =
      SquaredDistance(wall.SampleDirection, wall.Sample, queryWorld - modelCenterWorld);
  return seen;
}

template <typename ClosestPoint>
bool IsNearer(const ClosestPoint& one, const ClosestPoint& other) noexcept
{
  return one.SignedDistance < other.SignedDistance;
}

double RoomAt(const Vector3& place, const HalfSpace& plane) noexcept
{
  return plane.Normal.dot(place) - plane.Offset;
}

// Between two places that are proven free by half a radius there is no part of the surface, if they
// are less than that apart; a slide may end twice this step away.
double StepOf(const TouchableRadialModel& surface, double) noexcept
{
  return WedgeLimits::RelativeStep * surface.SmallestRadius();
}
double StepOf(const TouchableSurfaceModel& surface, double radius) noexcept
{
  return std::min(WedgeLimits::RelativeStep * surface.SmallestRadius(), 0.45 * radius);
}
} // namespace

template <typename Surface>
ContactWedgeOf<Surface>::ContactWedgeOf(std::shared_ptr<const Surface> surface, double radius,
                                        double ahead)
    : Touched(std::move(surface)), Radius(radius), LongestStep(StepOf(*this->Touched, radius)),
      Ahead(ahead), Kept(std::max(LongestStep, ahead)),
      End(std::max(WedgeLimits::RelativeEnd * this->Touched->SmallestRadius(),
                   2.0 * this->Touched->Rounding())),
      Clear(std::make_shared<Proof>(
          this->Touched->Search(), radius,
          std::min(
              0.5 * radius,
              std::max({WedgeLimits::RelativeTolerance<Surface> * this->Touched->SmallestRadius(),
                        2.0 * End, WedgeLimits::PartOfMargin * this->Touched->Margin()}))))
{
  if (ahead > 0.0)
  {
    constexpr double Tolerance = 0.01; // of the distance ahead
    this->ClearanceAhead =
        std::make_unique<Proof>(this->Touched->Search(), radius + ahead, Tolerance * ahead);
  }
}

template <typename Surface>
bool ContactWedgeOf<Surface>::IsNeeded(const Surface& surface, double radius)
{
  // About three directions per shortest wavelength of the surface.
  const IcosahedronDirections sphere(std::max(6, surface.Model().Degree()));
  const auto& directions = sphere.Directions();
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Vector3& direction)
                     { return IsNeededAt(surface, direction, radius); });
}

template <typename Surface>
bool ContactWedgeOf<Surface>::IsNeededAt(const Surface& surface, const Vector3& direction,
                                         double radius)
{
  if (!(radius > 0.0))
  {
    return false;
  }
  constexpr double Larger = 1.1;
  constexpr double Rounding = 1e-9;
  const double size = Larger * radius;
  const double least =
      (1.0 - Rounding) * size - Rounding * surface.LargestRadius() - 2.0 * surface.Rounding();
  const typename Surface::Place place = surface.PlaceAt(direction);
  const Vector3 center = place.PointWorld + size * place.Normal;
  return surface.Search().Nearest(center).SignedDistance < least;
}

template <typename Surface>
void ContactWedgeOf<Surface>::Begin(const ClosestPoint& nearest, const ProvenBall& known) noexcept
{
  this->Around = known;
  this->Center =
      nearest.PointWorld + std::max(this->Radius, nearest.SignedDistance) * nearest.Normal;
  this->IsClear = false;
  // Where the work of a tick may end before the first step.
  this->IsKeptBack = this->IsKeptBack || Surface::CountsAllWork;
  this->IsAtGoal = false;
  this->JointNormal = nearest.Normal;
  this->Known[0] = SeenFrom(this->Center, this->Touched->Model().CenterWorld(), nearest);
  this->KnownCount = 1;
  this->Rolled.Wall.State = ClosestPoint::Outcome::BadInput; // none
}

template <typename Surface>
void ContactWedgeOf<Surface>::MoveTo(const Vector3& goalWorld, int evaluations) noexcept
{
  this->EvaluationsLeft = evaluations;
  // Planes at a goal that is far away would be lost in rounding.
  const double far = 4.0 * (this->Touched->LargestRadius() + this->Radius);
  const Vector3 path = goalWorld - this->Center;
  const double length = path.stableNorm();
  this->Approach(length > far ? Vector3(this->Center + (far / length) * path) : goalWorld);
}

template <typename Surface>
void ContactWedgeOf<Surface>::LookAhead() noexcept
{
  if (!this->ClearanceAhead || !this->IsKeptBack || this->KnownCount == 0)
  {
    return;
  }
  constexpr std::size_t Most = 2; // walls that are found at once
  static_assert(MostWalls + Most <= Proof::MostKnown, "a proof takes all walls");
  const Vector3 place = this->Center + this->Ahead * this->JointNormal;
  std::array<ClosestPoint, Proof::MostKnown> walls;
  std::size_t count = 0;
  double nearest = this->Radius + this->Ahead;
  for (std::size_t i = 0; i < this->KnownCount; ++i)
  {
    walls[count] = this->Touched->Search().Track(place, this->Known[i]);
    nearest = std::min(nearest, walls[count++].SignedDistance);
  }
  for (std::size_t found = 0; found < Most && this->KnownCount < MostWalls; ++found)
  {
    const typename Proof::Answer answer = this->ClearanceAhead->AskWithin(
        nearest, place, walls.data(), count, WedgeLimits::EvaluationsAhead);
    if (answer.State != Proof::Finding::Nearer)
    {
      return;
    }
    walls[count++] = answer.Minimum;
    const ClosestPoint wall = this->Touched->Search().Track(this->Center, answer.Minimum);
    if (wall.Converged() && wall.SignedDistance < this->Radius + this->Kept)
    {
      this->Meet(wall);
    }
  }
}

template <typename Surface>
void ContactWedgeOf<Surface>::Approach(const Vector3& goalWorld) noexcept
{
  bool hasProven = false; // in this tick
  Leash leash{this->Center, this->LongestStep};
  this->IsAtGoal = false;
  for (int proof = 0; this->EvaluationsLeft > 0 && proof < WedgeLimits::Proofs; ++proof)
  {
    // An overlapping sphere is first pushed out by the shortest path.
    const Vector3 goal = this->IsClear ? this->NextGoal(goalWorld, leash) : this->Center;
    const bool isThere = this->Slide(goal, leash) && goal == goalWorld;
    leash.ClearWorld = this->IsClear ? leash.ClearWorld : this->Center;
    if (hasProven && this->IsClear && isThere &&
        (this->Center - leash.ClearWorld).norm() <= this->End)
    {
      this->IsAtGoal = true;
      return;
    }
    if (!this->IsClearOfWalls() || this->IsFartherOff(goal, isThere, leash))
    {
      this->Shorten(leash);
      continue;
    }
    const typename Proof::Answer answer =
        this->Clear->Ask(this->Center, this->Known.data(), this->KnownCount, this->EvaluationsLeft);
    this->Count(answer.Evaluations);
    if (answer.State == Proof::Finding::Nearer)
    {
      this->Meet(this->Sided(answer.Minimum));
      continue;
    }
    const double lower = std::max(answer.LowerDistance, this->Around.DistanceAt(this->Center));
    if (lower < WedgeLimits::LeastProven * this->Radius)
    {
      break;
    }
    this->Around = {this->Center, std::min(lower, this->Radius - this->End)};
    leash = {this->Center, std::min(2.0 * leash.Length, this->LongestStep)};
    hasProven = answer.State == Proof::Finding::Clear;
    if (std::exchange(this->IsClear, true) && isThere)
    {
      this->IsAtGoal = hasProven;
      return;
    }
  }
  if (leash.ClearWorld != this->Center)
  {
    this->GoBack(leash);
  }
}

// Where a wall was found late that is there too, the sphere is pushed out first.
template <typename Surface>
void ContactWedgeOf<Surface>::GoBack(const Leash& leash) noexcept
{
  this->GoTo(leash.ClearWorld, nullptr);
  this->IsClear = !Surface::MayCrossItself || this->IsClearOfWalls();
}

// The goal, or a point on the path to it whose held place is in reach: a place clipped from a
// longer path lies in or off walls that curve.
template <typename Surface>
Vector3 ContactWedgeOf<Surface>::NextGoal(const Vector3& goalWorld,
                                          const Leash& leash) const noexcept
{
  const std::array<HalfSpace, MostWalls> planes = this->Planes();
  const Vector3 held = NearestInHalfSpaces(goalWorld, planes.data(), this->KnownCount).Point;
  const Vector3 along =
      this->GrooveAt(planes.data(), held, goalWorld).Newton(held - leash.ClearWorld);
  const Vector3 inward = goalWorld - held;
  const double half = 0.5 * leash.Length;
  if (along.norm() <= leash.Length)
  {
    return goalWorld;
  }
  return leash.ClearWorld + half / along.norm() * along +
         std::min(1.0, half / inward.norm()) * inward;
}

template <typename Surface>
std::array<HalfSpace, ContactWedgeOf<Surface>::MostWalls>
ContactWedgeOf<Surface>::Planes() const noexcept
{
  std::array<HalfSpace, MostWalls> planes;
  for (std::size_t i = 0; i < this->KnownCount; ++i)
  {
    const ClosestPoint& wall = this->Known[i];
    planes[i] = {wall.Normal, wall.Normal.dot(wall.PointWorld) + this->Radius};
  }
  return planes;
}

// Planes that are inaccurate for a long step are accurate for a short one. At a surface model
// that is shorter than the step that was tried, which would only be repeated otherwise.
template <typename Surface>
void ContactWedgeOf<Surface>::Shorten(Leash& leash) noexcept
{
  constexpr double Shorter = 0.5;
  if (this->IsClear)
  {
    const double tried = (this->Center - leash.ClearWorld).norm();
    leash.Length =
        Shorter * (Surface::MayCrossItself ? std::min(leash.Length, tried) : leash.Length);
    this->GoBack(leash);
  }
}

template <typename Surface>
bool ContactWedgeOf<Surface>::IsClearOfWalls() const noexcept
{
  const double least = this->Radius - this->End;
  return std::all_of(this->Known.begin(),
                     this->Known.begin() + static_cast<std::ptrdiff_t>(this->KnownCount),
                     [&](const ClosestPoint& wall) { return wall.SignedDistance >= least; });
}

// Steps towards the place nearest to the goal that the known walls allow, at most a long step from
// a clear place; returns whether it was reached.
template <typename Surface>
bool ContactWedgeOf<Surface>::Slide(const Vector3& goalWorld, const Leash& leash) noexcept
{
  SlideRelaxation relaxation;
  double before = std::numeric_limits<double>::infinity();
  bool mayRoll = true;
  for (int step = 0; step < WedgeLimits::Steps; ++step)
  {
    const std::array<HalfSpace, MostWalls> planes = this->Planes();
    const NearestHeld held = NearestInHalfSpaces(goalWorld, planes.data(), this->KnownCount);
    const Vector3 push = held.Point - goalWorld;
    this->IsKeptBack = push.squaredNorm() > 0.0;
    if (this->IsKeptBack)
    {
      this->JointNormal = push.normalized();
    }
    if (held.IsHeld && mayRoll)
    {
      const Rolling rolling = this->Roll(goalWorld, leash, planes.data(), held.Point);
      if (rolling == Rolling::Done)
      {
        return true;
      }
      mayRoll = rolling != Rolling::NoMinimum || !Surface::MayCrossItself;
    }
    const WedgeGroove groove = this->GrooveAt(planes.data(), held.Point, goalWorld);
    const Vector3 left = held.Point - this->Center;
    const Vector3 path = this->Center +
                         (groove.IsKnown() ? groove.Newton(left) : relaxation.Relaxed(left)) -
                         leash.ClearWorld;
    const double length = path.norm();
    const Vector3 next = leash.ClearWorld + std::min(1.0, leash.Length / length) * path;
    const double moved = (next - this->Center).norm();
    this->GoTo(next, nullptr);
    if (moved <= this->End && held.IsHeld && length <= leash.Length)
    {
      return true;
    }
    if (moved <= this->End || this->IsBadStep(moved, std::exchange(before, moved)))
    {
      break;
    }
  }
  this->PushOut();
  this->ReturnToWall(goalWorld);
  return false;
}

// Whether steps that did not end led away from the goal.
template <typename Surface>
bool ContactWedgeOf<Surface>::IsFartherOff(const Vector3& goalWorld, bool isThere,
                                           const Leash& leash) const noexcept
{
  return Surface::MayCrossItself && this->IsClear && !isThere &&
         (goalWorld - this->Center).squaredNorm() > (goalWorld - leash.ClearWorld).squaredNorm();
}

// Whether a step led far into a wall that curves much, or that another one took the place of: more
// whole steps would go to and fro. Or whether steps hardly get shorter: more of them would not end.
template <typename Surface>
bool ContactWedgeOf<Surface>::IsBadStep(double moved, double before) const noexcept
{
  constexpr double Much = 0.05;
  constexpr double Slowly = 0.5;
  const ClosestPoint* nearest = this->NearestWall();
  return Surface::MayCrossItself && nearest != nullptr &&
         (moved > Slowly * before || this->Radius - nearest->SignedDistance > Much * moved);
}

// By the shortest path, from where steps towards a goal did not end: the next tick goes on there.
template <typename Surface>
void ContactWedgeOf<Surface>::PushOut() noexcept
{
  constexpr int Pushes = 3;
  for (int push = 0; Surface::MayCrossItself && push < Pushes && !this->IsClearOfWalls(); ++push)
  {
    const std::array<HalfSpace, MostWalls> planes = this->Planes();
    this->GoTo(NearestInHalfSpaces(this->Center, planes.data(), this->KnownCount).Point, nullptr);
  }
}

template <typename Surface>
const typename ContactWedgeOf<Surface>::ClosestPoint*
ContactWedgeOf<Surface>::NearestWall() const noexcept
{
  const ClosestPoint* end = this->Walls() + this->KnownCount;
  const ClosestPoint* nearest = std::min_element(this->Walls(), end, IsNearer<ClosestPoint>);
  return nearest == end ? nullptr : nearest;
}

// Along a wall's plane a fast sphere leaves a surface that curves away: moves back by the gap, the
// smallest of all known walls.
template <typename Surface>
void ContactWedgeOf<Surface>::ReturnToWall(const Vector3& goalWorld) noexcept
{
  const ClosestPoint* nearest = this->NearestWall();
  if (nearest != nullptr && nearest->SignedDistance > this->Radius &&
      (goalWorld - this->Center).dot(nearest->Normal) < 0.0)
  {
    this->GoTo(this->Center - (nearest->SignedDistance - this->Radius) * nearest->Normal, nullptr);
  }
}

template <typename Surface>
typename ContactWedgeOf<Surface>::Holders
ContactWedgeOf<Surface>::HoldersAt(const Vector3& heldWorld, const HalfSpace* planes) const noexcept
{
  const double rounding = 1e-12 * (this->Touched->LargestRadius() + this->Radius);
  Holders holders;
  for (std::size_t i = 0; i < this->KnownCount; ++i)
  {
    if (RoomAt(heldWorld, planes[i]) <= rounding)
    {
      holders.Each[holders.Count++] = i;
    }
  }
  return holders;
}

// Radial models do without.
template <typename Surface>
WedgeGroove ContactWedgeOf<Surface>::GrooveAt(const HalfSpace* planes, const Vector3& heldWorld,
                                              const Vector3& goalWorld) const noexcept
{
  if constexpr (Surface::MayCrossItself)
  {
    const Holders holders = this->HoldersAt(heldWorld, planes);
    return holders.Count == 2 ? WedgeGroove(this->Known[holders.Each[0]],
                                            this->Known[holders.Each[1]], heldWorld - goalWorld)
                              : WedgeGroove();
  }
  else
  {
    return {};
  }
}

// A wall as the minimum of the distance to the goal, which is far from it in a deep hollow:
// continued from the last goal.
template <typename Surface>
const typename ContactWedgeOf<Surface>::ClosestPoint&
ContactWedgeOf<Surface>::AtGoal(const Vector3& goalWorld, const ClosestPoint& wall,
                                const Leash& leash) noexcept
{
  constexpr double Near = 0.1; // rad, which a wall may have moved
  const auto away = [&](const ClosestPoint& each)
  { return (this->Rolled.From - each.Direction).squaredNorm(); };
  // Of two walls that are near, the nearer one to where it was.
  const bool isSame =
      this->Rolled.Wall.State != ClosestPoint::Outcome::BadInput && away(wall) < Near * Near &&
      std::none_of(this->Walls(), this->Walls() + this->KnownCount,
                   [&](const ClosestPoint& each) { return away(each) < away(wall); });
  const ClosestPoint& last = this->Rolled.Wall;
  const bool isThere = goalWorld == this->Center; // where the wall itself is the minimum
  if (isSame && !isThere && this->Rolled.GoalWorld == goalWorld)
  {
    return last;
  }
  const Vector3 place = last.PointWorld + this->Radius * last.Normal;
  const bool isNear = isSame && !isThere && last.Converged() &&
                      last.Normal.dot(wall.Normal) > 0.0 &&
                      (place - leash.ClearWorld).norm() <= leash.Length;
  this->Rolled = {wall.Direction, goalWorld,
                  this->Touched->Search().Track(goalWorld, isNear ? last : wall)};
  this->Count(this->Rolled.Wall.Evaluations);
  return this->Rolled.Wall;
}

// If a single plane holds the sphere, a single wall does, and the result is the nearest point to
// the goal, if the other walls allow it.
template <typename Surface>
typename ContactWedgeOf<Surface>::Rolling
ContactWedgeOf<Surface>::Roll(const Vector3& goalWorld, const Leash& leash, const HalfSpace* planes,
                              const Vector3& heldWorld) noexcept
{
  const Holders holders = this->HoldersAt(heldWorld, planes);
  if (holders.Count != 1)
  {
    return Rolling::Kept;
  }
  const std::size_t touched = holders.Each[0];
  const ClosestPoint& wall = this->AtGoal(goalWorld, this->Known[touched], leash);
  const Vector3 place = wall.PointWorld + this->Radius * wall.Normal;
  bool isAllowed = wall.Converged() && wall.SignedDistance <= this->Radius &&
                   (place - leash.ClearWorld).norm() <= leash.Length;
  for (std::size_t i = 0; i < this->KnownCount && isAllowed; ++i)
  {
    isAllowed = i == touched || RoomAt(place, planes[i]) >= 0.0;
  }
  if (isAllowed)
  {
    std::swap(this->Known[0], this->Known[touched]);
    this->GoTo(place, &wall);
    this->JointNormal = wall.Normal;
  }
  return isAllowed ? Rolling::Done : wall.Converged() ? Rolling::Kept : Rolling::NoMinimum;
}

// Walls are kept while they are near. The touched one, if known, is the first.
template <typename Surface>
void ContactWedgeOf<Surface>::GoTo(const Vector3& placeWorld, const ClosestPoint* touched) noexcept
{
  this->Center = placeWorld;
  const auto walls = this->Known;
  const std::size_t count = std::exchange(this->KnownCount, 0);
  for (std::size_t i = 0; i < count; ++i)
  {
    const bool isTouched = i == 0 && touched != nullptr;
    const ClosestPoint wall =
        isTouched ? SeenFrom(placeWorld, this->Touched->Model().CenterWorld(), *touched)
                  : this->Sided(
                        this->Touched->Search().Track(placeWorld, walls[i], WedgeLimits::Tracking));
    this->Count(isTouched ? 0 : wall.Evaluations);
    // A minimum that is not strict, as around the axis of a round hollow, is a wall too.
    if (isTouched || wall.SignedDistance < this->Radius + this->Kept)
    {
      this->Meet(wall);
    }
  }
}

// With too many walls the farthest is dropped; if it matters it will be found again.
template <typename Surface>
void ContactWedgeOf<Surface>::Meet(const ClosestPoint& wall) noexcept
{
  const auto end = this->Known.begin() + static_cast<std::ptrdiff_t>(this->KnownCount);
  constexpr double Apart = Proof::Apart;
  const bool isKnown =
      std::any_of(this->Known.begin(), end,
                  [&](const ClosestPoint& known)
                  { return (known.Direction - wall.Direction).squaredNorm() < Apart * Apart; });
  if (isKnown)
  {
    return;
  }
  if (this->KnownCount < MostWalls)
  {
    this->Known[this->KnownCount++] = wall;
    return;
  }
  *std::max_element(this->Known.begin(), end, IsNearer<ClosestPoint>) = wall;
}

// Within a step of a clear place there is no part of the surface: the sphere is on the outer side
// of every wall there, also where the tracked point has moved over a fold.
template <typename Surface>
typename ContactWedgeOf<Surface>::ClosestPoint
ContactWedgeOf<Surface>::Sided(const ClosestPoint& wall) const noexcept
{
  if constexpr (Surface::MayCrossItself)
  {
    return this->IsClear ? this->Touched->SeenFromOutside(wall) : wall;
  }
  return wall;
}

template class ContactWedgeOf<TouchableRadialModel>;
template class ContactWedgeOf<TouchableSurfaceModel>;
} // namespace palpate
