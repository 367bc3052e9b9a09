#include "ClearMotion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace palpate
{
namespace
{
constexpr double Endless = std::numeric_limits<double>::infinity();
// Work, in evaluations of the surface, of a proof. Where that does not end the whole surface is
// searched, since a tool that waits meets its wall too late.
constexpr int MotionEvaluationsOfProof = 160;
constexpr int MotionEvaluationsOfSearch = 128;
constexpr int MotionSteps = 32;
constexpr int MotionProofs = 5;
constexpr int MotionMeetings = 4;          // of walls in one step
constexpr double ShortestStep = 0.05;      // of the longest
constexpr double MotionPartOfRadius = 0.5; // short steps of a sphere
// Of the smallest radius: how deep in a sphere parts of the surface may be that a proof leaves to
// the next tick.
constexpr double MotionSlack = 1e-3;
// Of the room in which nothing is, that a proof is for.
constexpr double WantedPart = 2.0 / 3.0;
} // namespace

double ClearMotion::Minima::Nearest() const noexcept
{
  double nearest = Endless;
  for (std::size_t i = 0; i < this->Count; ++i)
  {
    nearest = std::min(nearest, std::abs(this->Each[i].SignedDistance));
  }
  return nearest;
}

ClearMotion::ClearMotion(const TouchableSurfaceModel& surface, const WedgePlaces& places,
                         double radius, double stride, double exactness,
                         std::shared_ptr<Proof> clearance)
    : Surface(&surface), Places(&places), Radius(radius), Free(radius + surface.Margin()),
      Stride(stride), Exactness(exactness),
      Slack(std::min(MotionSlack * surface.SmallestRadius(), 0.25 * radius)),
      Clearance(clearance ? std::move(clearance)
                          : std::make_shared<Proof>(surface.Search(), Free + stride, exactness))
{
}

void ClearMotion::Begin(const Vector3& placeWorld, const ClosestPoint& minimum) noexcept
{
  this->Place = placeWorld;
  this->Known.PlaceWorld = placeWorld;
  this->Known.Each[0] = minimum;
  this->Known.Count = this->IsExact(minimum) ? 1 : 0;
  this->BallCenter = placeWorld;
  this->BallRadius = 0.0;
}

bool ClearMotion::MoveTo(const Vector3& probeWorld, int evaluations) noexcept
{
  this->EvaluationsLeft = evaluations;
  double longest = this->Stride;
  for (int step = 0; this->EvaluationsLeft > 0 && step < MotionSteps; ++step)
  {
    const Vector3 start = this->EndOfBall(probeWorld);
    const Vector3 path = probeWorld - start;
    const double length = path.norm();
    this->Place = start;
    this->Start = start;
    if (!(length > 0.0))
    {
      return true;
    }
    const Vector3 goal = length > longest ? Vector3(start + (longest / length) * path) : probeWorld;
    const Step result = this->StepTo(start, goal);
    if (result == Step::Met)
    {
      return false;
    }
    longest = result == Step::Taken ? std::min(2.0 * longest, this->Stride)
                                    : 0.25 * std::min(longest, length);
  }
  return !this->IsHeldUp(probeWorld);
}

// Whether a wall is next to a tool whose work ended before it could follow the probe: in a hollow
// as round as the tool, steps become ever shorter. Contact begins there, and ends at once if no
// wall holds the tool; a tool that waited would be pressed in without a force.
bool ClearMotion::IsHeldUp(const Vector3& probe) noexcept
{
  const double near = ShortestStep * this->Stride;
  if ((probe - this->Place).norm() <= near)
  {
    return false;
  }
  const ClosestPoint nearest = this->Surface->SeenFromOutside(
      this->Surface->Search().Nearest(this->Place, MotionEvaluationsOfSearch));
  if (!(nearest.SignedDistance < this->RadiusAt(nearest) + near))
  {
    return false;
  }
  this->Wall = nearest;
  return true;
}

// The last point in the ball on the path to the probe.
Vector3 ClearMotion::EndOfBall(const Vector3& probe) const noexcept
{
  if ((probe - this->BallCenter).norm() <= this->BallRadius)
  {
    return probe;
  }
  const Vector3 path = probe - this->Place;
  const Vector3 from = this->Place - this->BallCenter;
  const double square = path.squaredNorm();
  const double along = path.dot(from);
  const double room = this->BallRadius * this->BallRadius - from.squaredNorm();
  if (!(this->BallRadius > 0.0) || !(room > 0.0) || !(square > 0.0))
  {
    return this->Place;
  }
  const double part = (std::sqrt(along * along + square * room) - along) / square;
  return this->Place + std::clamp(part, 0.0, 1.0) * path;
}

double ClearMotion::RadiusAt(const ClosestPoint& minimum) const noexcept
{
  return this->Places->Contains(minimum.Direction) ? this->Free : this->Radius;
}

ClearMotion::Step ClearMotion::StepTo(const Vector3& start, const Vector3& goal) noexcept
{
  if (this->IsFar(goal))
  {
    return Step::Taken;
  }
  const std::size_t knownBefore = this->Known.Count;
  Minima minima = this->Continued(goal);
  if (const ClosestPoint* touched = this->Touched(minima))
  {
    this->MeetFirst(start, goal, *touched);
    return Step::Met;
  }
  if (knownBefore > 0 && minima.Count > 0 && this->IsAlone(this->Known.Each[0], minima.Each[0]))
  {
    minima.Count = 1;
    this->Take(goal, minima, 0.0);
    return Step::Taken;
  }
  if (this->IsShort(start, goal))
  {
    return this->StepShortly(start, goal, minima);
  }
  const double needed = this->Free + (goal - start).norm();
  constexpr double LongestPart = 0.5;
  const double longest = std::max({LongestPart * (minima.Nearest() - this->Free),
                                   ShortestStep * this->Stride, this->Exactness});
  if (needed > this->Free + longest)
  {
    return Step::TooLong;
  }
  const Step proven = this->Prove(start, goal, needed, minima);
  return proven == Step::Open ? this->SearchAt(start, goal, needed) : proven;
}

// A sphere keeps two sheets apart without the margin, which can't be proven above a hollow as round
// as the sphere: there the sphere would wait in vain.
ClearMotion::Step ClearMotion::StepShortly(const Vector3& start, const Vector3& goal,
                                           Minima& minima) noexcept
{
  const double margin = this->Surface->Margin();
  const double needed = this->Radius > margin ? this->Radius : this->Free;
  Step proven = Step::Open;
  if (margin > 0.0)
  {
    proven = this->Prove(start, goal, this->Free, minima);
  }
  if (proven == Step::Open && this->EvaluationsLeft > 0)
  {
    proven = this->Prove(start, goal, needed, minima);
  }
  return proven == Step::Open ? this->SearchAt(start, goal, needed) : proven;
}

// Whether no part of the surface is between two places, since nothing is as near to the first one.
bool ClearMotion::IsShort(const Vector3& start, const Vector3& goal) const noexcept
{
  return (goal - start).norm() < MotionPartOfRadius * this->Radius;
}

// Far away the ball outside of the sphere around the surface suffices.
bool ClearMotion::IsFar(const Vector3& place) noexcept
{
  const double largest = this->Surface->LargestRadius();
  const double room = (place - this->Surface->Model().CenterWorld()).norm() - largest - this->Free;
  if (!(room > 0.25 * largest))
  {
    return false;
  }
  this->Known.Count = 0;
  this->Take(place, this->Known, room + this->Free);
  return true;
}

// Whether this is the nearest point. The direction of the normal shows that no sheet was stepped
// over.
bool ClearMotion::IsAlone(const ClosestPoint& last, const ClosestPoint& next) const noexcept
{
  constexpr double LeastCosine = 0.5;
  return this->Places->IsNearest(next) && next.Normal.dot(last.Normal) > LeastCosine;
}

// Without those that cannot be followed, or that may have become others.
ClearMotion::Minima ClearMotion::Continued(const Vector3& goal) noexcept
{
  constexpr double Faster = 4.0;
  const double farthest = Faster * (goal - this->Known.PlaceWorld).norm() + this->Exactness;
  Minima minima;
  minima.PlaceWorld = goal;
  for (std::size_t i = 0; i < this->Known.Count; ++i)
  {
    const ClosestPoint& last = this->Known.Each[i];
    ClosestPoint& next = minima.Each[minima.Count];
    next = this->Surface->Search().Track(goal, last);
    this->EvaluationsLeft -= std::max(1, next.Evaluations);
    const bool isSame = this->IsExact(next) && next.Normal.dot(last.Normal) > 0.0 &&
                        (next.PointWorld - last.PointWorld).norm() <= farthest;
    minima.Count += isSame ? 1 : 0;
  }
  return minima;
}

const ClearMotion::ClosestPoint* ClearMotion::Touched(const Minima& minima) const noexcept
{
  for (std::size_t i = 0; i < minima.Count; ++i)
  {
    if (minima.Each[i].SignedDistance < this->RadiusAt(minima.Each[i]))
    {
      return &minima.Each[i];
    }
  }
  return nullptr;
}

// Several walls may be overlapped at the goal, of which a proof finds any first: what overlaps the
// tool where it touches one was met before that one. Takes much work, since the first wall decides
// about all of the contact; walls that are met within the slack of each other count as one time.
void ClearMotion::MeetFirst(const Vector3& start, const Vector3& goal,
                            const ClosestPoint& minimum) noexcept
{
  constexpr double Apart = 0.0;
  this->Meet(start, goal, minimum);
  for (int met = 1; met < MotionMeetings && !this->Places->IsNearest(this->Wall); ++met)
  {
    const auto answer = this->Clearance->AskWithin(
        this->Free - std::max(this->Slack, this->Exactness) + this->Clearance->Tolerance(),
        this->Place, &this->Wall, 1, MotionEvaluationsOfProof, Apart);
    this->EvaluationsLeft -= answer.Evaluations;
    const ClosestPoint found = this->Surface->SeenFromOutside(answer.Minimum);
    if (answer.State != Proof::Finding::Nearer ||
        found.SignedDistance > this->RadiusAt(found) - this->Exactness)
    {
      return;
    }
    this->Meet(start, Vector3(this->Place), found);
  }
}

// Where on the step the tool touches: the distance changes almost linearly.
void ClearMotion::Meet(const Vector3& start, const Vector3& goal,
                       const ClosestPoint& minimum) noexcept
{
  const auto& search = this->Surface->Search();
  const double radius = this->RadiusAt(minimum);
  const ClosestPoint first = search.Track(start, minimum);
  const double fall = first.SignedDistance - minimum.SignedDistance;
  const double part =
      fall > 0.0 ? std::clamp((first.SignedDistance - radius) / fall, 0.0, 1.0) : 0.0;
  this->Place = start + part * (goal - start);
  this->Wall = search.Track(this->Place, minimum);
  if (!this->Wall.Converged())
  {
    this->Wall = this->Surface->PointAt(minimum.Direction, this->Place, minimum);
  }
}

// How far it is worth while to look for others: not as far as the nearest point, since the last bit
// takes most of the work.
double ClearMotion::Wanted(double needed, const Minima& minima) const noexcept
{
  return std::max(needed, minima.Count == 0 ? this->Free + 2.0 * this->BallRadius
                                            : this->PartOfGap(WantedPart, minima.Nearest()));
}

// Looks for others that the goal is too near to, and goes there if there are none.
ClearMotion::Step ClearMotion::Prove(const Vector3& start, const Vector3& goal, double needed,
                                     Minima& minima) noexcept
{
  const bool isShort = needed <= this->Free && this->IsShort(start, goal);
  const double enough = isShort ? needed - this->Slack : needed;
  double wanted = this->Wanted(needed, minima);
  for (int proof = 0; this->EvaluationsLeft > 0 && proof < MotionProofs; ++proof)
  {
    constexpr double Apart = 0.0; // minima are not merged however near they are
    const double asked = wanted + 0.5 * this->Exactness;
    const auto answer = this->Clearance->AskWithin(
        asked + this->Clearance->Tolerance(), goal, minima.Each.data(), minima.Count,
        std::min(this->EvaluationsLeft, MotionEvaluationsOfProof), Apart);
    this->EvaluationsLeft -= answer.Evaluations;
    if (answer.State != Proof::Finding::Nearer)
    {
      return this->TakeIf(answer.LowerDistance >= enough, goal, minima, answer.LowerDistance);
    }
    const ClosestPoint found = this->Surface->SeenFromOutside(answer.Minimum);
    if (isShort && found.SignedDistance < this->RadiusAt(found))
    {
      this->MeetFirst(start, goal, found);
      return Step::Met;
    }
    if (!this->IsExact(found))
    {
      return Step::Open;
    }
    if (found.SignedDistance < needed && needed > this->Free + this->Exactness)
    {
      this->Remember(found);
      return Step::TooLong;
    }
    wanted = this->With(found, needed, minima);
  }
  return Step::Open;
}

// Where a proof does not end. A wall that is nearer than needed is known from then on. In a hollow
// as round as the tool no minimum is exact; there whatever overlaps the tool is met, or the tool
// would wait for a proof that never ends. A step within the room that the tool had is on its side;
// if no wall next to a crossing is known to be as near as the margin, the tool takes a step that
// stays in the empty ball around its end: a point would not move any more next to a wall that is
// nearer than the margin.
ClearMotion::Step ClearMotion::SearchAt(const Vector3& start, const Vector3& goal,
                                        double needed) noexcept
{
  Minima minima;
  const double others = this->Search(goal, minima);
  if (others < needed && minima.Count > 0 &&
      (goal - start).norm() < others - this->Radius - this->Exactness)
  {
    // What is known of walls next to crossings is not given up.
    Minima all = this->Continued(goal);
    all.Add(minima.Each[0]);
    if (this->Touched(all) == nullptr)
    {
      this->Take(goal, all, others + this->Surface->Margin());
      return Step::Taken;
    }
  }
  if (others < needed && minima.Count > 0)
  {
    this->Remember(minima.Each[0]);
  }
  else if (const ClosestPoint& nearest = minima.Each[0];
           others < needed && (goal - start).norm() < this->Free &&
           nearest.SignedDistance < this->RadiusAt(nearest))
  {
    this->Meet(start, goal, nearest);
    return Step::Met;
  }
  return this->TakeIf(others >= needed, goal, minima, others);
}

// How far to look then.
double ClearMotion::With(const ClosestPoint& found, double needed, Minima& minima) noexcept
{
  if (found.SignedDistance <= needed + 2.0 * this->Exactness)
  {
    minima.Add(found);
    return needed;
  }
  if (found.SignedDistance < minima.Nearest())
  {
    minima.Each[0] = found;
    minima.Count = 1;
    this->Known = minima;
  }
  return std::max(needed, this->PartOfGap(WantedPart, found.SignedDistance));
}

// A minimum that the tool could have passed on the way to where it was found: continued to where
// the tool is.
void ClearMotion::Remember(const ClosestPoint& found) noexcept
{
  const ClosestPoint here = this->Surface->Search().Track(this->Place, found);
  this->EvaluationsLeft -= std::max(1, here.Evaluations);
  if (this->IsExact(here))
  {
    this->Known.Count = this->Known.PlaceWorld == this->Place ? this->Known.Count : 0;
    this->Known.PlaceWorld = this->Place;
    this->Known.Add(this->Surface->SeenFromOutside(here));
  }
}

// Where minima are not strict. Returns the distance of all.
double ClearMotion::Search(const Vector3& goal, Minima& minima) noexcept
{
  const ClosestPoint nearest = this->Surface->Search().Nearest(goal, MotionEvaluationsOfSearch);
  this->EvaluationsLeft -= nearest.Evaluations;
  minima.Each[0] = this->Surface->SeenFromOutside(nearest);
  minima.Count = this->IsExact(nearest) ? 1 : 0;
  return std::abs(nearest.SignedDistance) - nearest.DistanceError;
}

ClearMotion::Step ClearMotion::TakeIf(bool isProven, const Vector3& goal, const Minima& minima,
                                      double others) noexcept
{
  if (!isProven)
  {
    return Step::Open;
  }
  this->Take(goal, minima, others);
  return Step::Taken;
}

// Where no part of the surface but these minima is nearer than `others`, mm.
void ClearMotion::Take(const Vector3& goal, const Minima& minima, double others) noexcept
{
  this->Place = goal;
  this->Known = minima;
  this->Known.PlaceWorld = goal;
  this->BallCenter = goal;
  this->BallRadius = others - this->Free;
  for (std::size_t i = 0; i < minima.Count; ++i)
  {
    const ClosestPoint& each = minima.Each[i];
    this->BallRadius = std::min(this->BallRadius, each.SignedDistance - this->RadiusAt(each));
  }
  this->BallRadius = std::max(0.0, this->BallRadius);
}
} // namespace palpate
