#pragma once

#include "HalfSpaces.h"
#include "TouchableRadialModel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace palpate::test
{
/// Reference for ContactWedge: the same by certified searches of the whole surface, one per step.
class SearchedWedge
{
public:
  SearchedWedge(std::shared_ptr<const TouchableRadialModel> surface, double radius)
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

  std::shared_ptr<const TouchableRadialModel> Surface;
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
  bool isMoving = true;
  for (int step = 0; step < MostSteps && isMoving; ++step)
  {
    isMoving = this->Step(goalWorld);
  }
  // Walls that were reached in the last step, or that leave no place between them: moves out by the
  // shortest distance.
  bool isOverlapping = true;
  for (int step = 0; step < MostSteps && isOverlapping; ++step)
  {
    isOverlapping = this->Step(this->Center);
  }
  this->ReturnToSurface(goalWorld);
}

// Along a wall's plane a fast sphere leaves a surface that bends away. After returning by the gap
// it is no closer to another wall than its radius, since the closest one was the closest.
inline void SearchedWedge::ReturnToSurface(const Vector3& goalWorld) noexcept
{
  const ClosestPoint wall = this->Surface->Search().Nearest(this->Center, EvaluationsOfStep);
  const double gap = wall.SignedDistance - wall.DistanceError - this->Radius;
  if (gap > 0.0 && this->Center != goalWorld)
  {
    this->Center -= gap * wall.Normal;
  }
}

// Moves to the place closest to the goal that the walls' planes allow; false if that is here.
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
  const Vector3 move = held.Point - this->Center;
  const double length = move.norm();
  this->Center += std::min(1.0, this->LongestStep / length) * move;
  return held.IsHeld && length > Enough * this->LongestStep;
}

// Walls are kept while they are close, and the closest point of the whole surface is one of them.
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
