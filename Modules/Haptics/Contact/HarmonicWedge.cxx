#include "HarmonicWedge.h"

#include "HalfSpaces.h"
#include "IcosahedronDirections.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
// Of the smallest radius, so that units do not matter.
constexpr double RelativeStep = 1.0 / 16.0;
constexpr double Enough = 1e-4;
constexpr int MostSteps = 6;
// So many find the nearest wall, if not the proof that there is no other.
constexpr int MostEvaluations = 64;
constexpr int ProvingEvaluations = 512;
// Walls are one where the surface between them turns by less (rad), seen from the centre.
constexpr double Apart = 0.01;
} // namespace

HarmonicWedge::HarmonicWedge(std::shared_ptr<const HarmonicSurface> surface, double radius)
    : Surface(std::move(surface)), Radius(radius),
      LongestStep(RelativeStep * this->Surface->SmallestRadius())
{
}

bool HarmonicWedge::IsNeeded(const HarmonicSurface& surface, double radius)
{
  if (!(radius > 0.0))
  {
    return false;
  }
  constexpr double Larger = 1.1;
  constexpr double Rounding = 1e-9;
  const double size = Larger * radius;
  // Some three directions along the finest wave of the surface.
  const IcosahedronDirections sphere(std::max(6, surface.Model().Degree()));
  const auto& directions = sphere.Directions();
  return std::any_of(directions.begin(), directions.end(),
                     [&](const Vector3& u)
                     {
                       const HarmonicSurface::Place place = surface.PlaceAt(u);
                       const Vector3 center = place.PointWorld + size * place.Normal;
                       return surface.Search().Nearest(center).SignedDistance <
                              (1.0 - Rounding) * size - Rounding * surface.LargestRadius();
                     });
}

void HarmonicWedge::Begin(const Vector3& centerWorld) noexcept
{
  this->Center = centerWorld;
  this->WallCount = 0;
}

void HarmonicWedge::MoveTo(const Vector3& goalWorld) noexcept
{
  bool isOnItsWay = true;
  for (int step = 0; step < MostSteps && isOnItsWay; ++step)
  {
    isOnItsWay = this->Step(goalWorld);
  }
  // Walls that were met on the last step, or that leave no place between them: out by the shortest
  // way.
  bool isOverlapping = true;
  for (int step = 0; step < MostSteps && isOverlapping; ++step)
  {
    isOverlapping = this->Step(this->Center);
  }
  this->ReturnToSurface(goalWorld);
}

// Along a wall's plane a fast ball leaves a surface that bends away. Back by the gap it is nearer
// to no other wall than its radius, since the nearest one was the nearest.
void HarmonicWedge::ReturnToSurface(const Vector3& goalWorld) noexcept
{
  const ClosestPoint wall = this->Surface->Search().Nearest(this->Center, ProvingEvaluations);
  const double gap = wall.SignedDistance - wall.DistanceError - this->Radius;
  if (gap > 0.0 && this->Center != goalWorld)
  {
    this->Center -= gap * wall.Normal;
  }
}

// Goes on to the place nearest to the goal that the walls' planes allow; false where that is here.
bool HarmonicWedge::Step(const Vector3& goalWorld) noexcept
{
  this->FollowWalls();
  std::array<HalfSpace, MostWalls> planes;
  for (std::size_t i = 0; i < this->WallCount; ++i)
  {
    const ClosestPoint& wall = this->Walls[i];
    planes[i] = {wall.Normal, wall.Normal.dot(wall.PointWorld) + this->Radius};
  }
  const NearestHeld held = NearestInHalfSpaces(goalWorld, planes.data(), this->WallCount);
  const Vector3 push = held.Point - goalWorld;
  if (push.squaredNorm() > 0.0 && goalWorld != this->Center)
  {
    this->JointNormal = push.normalized();
  }
  const Vector3 way = held.Point - this->Center;
  const double length = way.norm();
  this->Center += std::min(1.0, this->LongestStep / length) * way;
  return held.IsHeld && length > Enough * this->LongestStep;
}

// Walls are kept while they are near, and the nearest point of the whole surface is one.
void HarmonicWedge::FollowWalls() noexcept
{
  const auto walls = this->Walls;
  const std::size_t count = std::exchange(this->WallCount, 0);
  this->Meet(this->Surface->Search().Nearest(this->Center, MostEvaluations));
  for (std::size_t i = 0; i < count; ++i)
  {
    const ClosestPoint wall = this->Surface->Search().Track(this->Center, walls[i]);
    if (wall.Converged() && wall.SignedDistance < this->Radius + this->LongestStep)
    {
      this->Meet(wall);
    }
  }
}

void HarmonicWedge::Meet(const ClosestPoint& wall) noexcept
{
  const auto end = this->Walls.begin() + static_cast<std::ptrdiff_t>(this->WallCount);
  const bool isKnown =
      std::any_of(this->Walls.begin(), end,
                  [&](const ClosestPoint& known)
                  { return (known.Direction - wall.Direction).squaredNorm() < Apart * Apart; });
  if (!isKnown && this->WallCount < MostWalls)
  {
    this->Walls[this->WallCount++] = wall;
  }
}
} // namespace palpate
