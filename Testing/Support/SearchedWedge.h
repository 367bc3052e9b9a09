#pragma once

#include "HalfSpaces.h"
#include "HarmonicSurface.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace palpate::test
{
/// The oracle of HarmonicWedge: the same by certified searches of the whole surface, one a step.
class SearchedWedge
{
public:
  SearchedWedge(std::shared_ptr<const HarmonicSurface> surface, double radius)
      : Surface(std::move(surface)), Radius(radius),
        LongestStep(this->Surface->SmallestRadius() / 16.0)
  {
  }

  void Begin(const Vector3& centerWorld) noexcept;
  void MoveTo(const Vector3& goalWorld) noexcept;
  const Vector3& CenterWorld() const noexcept { return this->Center; }

private:
  static constexpr std::size_t MostWalls = 4;
  static constexpr int MostSteps = 6;
  static constexpr int EvaluationsOfStep = 5000;
  static constexpr double Enough = 1e-4; // of the longest step
  static constexpr double Apart = 0.01;  // rad

  bool Step(const Vector3& goalWorld) noexcept;
  void ReturnToSurface(const Vector3& goalWorld) noexcept;
  void FollowWalls() noexcept;
  void Meet(const ClosestPoint& wall) noexcept;

  std::shared_ptr<const HarmonicSurface> Surface;
  double Radius;
  double LongestStep; // mm
  Vector3 Center = Vector3::Zero();
  std::array<ClosestPoint, MostWalls> Walls{};
  std::size_t WallCount = 0;
};

inline void SearchedWedge::Begin(const Vector3& centerWorld) noexcept
{
  this->Center = centerWorld;
  this->WallCount = 0;
}

inline void SearchedWedge::MoveTo(const Vector3& goalWorld) noexcept
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
inline void SearchedWedge::ReturnToSurface(const Vector3& goalWorld) noexcept
{
  const ClosestPoint wall = this->Surface->Search().Nearest(this->Center, EvaluationsOfStep);
  const double gap = wall.SignedDistance - wall.DistanceError - this->Radius;
  if (gap > 0.0 && this->Center != goalWorld)
  {
    this->Center -= gap * wall.Normal;
  }
}

// Goes on to the place nearest to the goal that the walls' planes allow; false where that is here.
inline bool SearchedWedge::Step(const Vector3& goalWorld) noexcept
{
  this->FollowWalls();
  std::array<HalfSpace, MostWalls> planes;
  for (std::size_t i = 0; i < this->WallCount; ++i)
  {
    const ClosestPoint& wall = this->Walls[i];
    planes[i] = {wall.Normal, wall.Normal.dot(wall.PointWorld) + this->Radius};
  }
  const NearestHeld held = NearestInHalfSpaces(goalWorld, planes.data(), this->WallCount);
  const Vector3 way = held.Point - this->Center;
  const double length = way.norm();
  this->Center += std::min(1.0, this->LongestStep / length) * way;
  return held.IsHeld && length > Enough * this->LongestStep;
}

// Walls are kept while they are near, and the nearest point of the whole surface is one.
inline void SearchedWedge::FollowWalls() noexcept
{
  const auto walls = this->Walls;
  const std::size_t count = std::exchange(this->WallCount, 0);
  this->Meet(this->Surface->Search().Nearest(this->Center, EvaluationsOfStep));
  for (std::size_t i = 0; i < count; ++i)
  {
    const ClosestPoint wall = this->Surface->Search().Track(this->Center, walls[i]);
    if (wall.Converged() && wall.SignedDistance < this->Radius + this->LongestStep)
    {
      this->Meet(wall);
    }
  }
}

inline void SearchedWedge::Meet(const ClosestPoint& wall) noexcept
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
} // namespace palpate::test
