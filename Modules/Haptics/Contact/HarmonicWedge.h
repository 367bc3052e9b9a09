#pragma once

#include "ClosestPoint.h"
#include "HarmonicSurface.h"

#include <array>
#include <cstddef>
#include <memory>

namespace palpate
{
/// Keeps a ball out of a star-shaped surface that has hollows too narrow for it: brings it to the
/// place nearest to a goal where no part of the surface is nearer than its radius. Up to four
/// walls, minima of the distance that are apart, are followed; their tangent planes allow a next
/// place, where the walls are asked again, and so on. One search of the whole surface a step, so
/// this is for balls that need it.
class HarmonicWedge
{
public:
  HarmonicWedge(std::shared_ptr<const HarmonicSurface> surface, double radius);

  /// False if a ball (mm) touches in one place only wherever it may roll, found by trying some
  /// thousand places with a ball a tenth larger. Takes milliseconds.
  static bool IsNeeded(const HarmonicSurface& surface, double radius);

  /// With the ball free of the surface here.
  void Begin(const Vector3& centerWorld) noexcept;
  /// Steps on from the last place; the walls' joint normal is then Normal().
  void MoveTo(const Vector3& goalWorld) noexcept;

  const Vector3& CenterWorld() const noexcept { return this->Center; }
  const Vector3& Normal() const noexcept { return this->JointNormal; }

private:
  static constexpr std::size_t MostWalls = 4;

  bool Step(const Vector3& goalWorld) noexcept;
  void ReturnToSurface(const Vector3& goalWorld) noexcept;
  void FollowWalls() noexcept;
  void Meet(const ClosestPoint& wall) noexcept;

  std::shared_ptr<const HarmonicSurface> Surface;
  double Radius;
  double LongestStep; // mm
  Vector3 Center = Vector3::Zero();
  Vector3 JointNormal = Vector3::UnitZ();
  std::array<ClosestPoint, MostWalls> Walls{};
  std::size_t WallCount = 0;
};
} // namespace palpate
