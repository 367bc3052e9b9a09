#pragma once

#include "ClosestPoint.h"
#include "CoupledPatches.h"
#include "TouchableRadialModel.h"
#include "Vector3.h"

#include <array>
#include <cstddef>

namespace palpate
{
/// Where the walls of an organ hold a ball that does not fit into a hollow: not at once, as a rigid
/// organ would, but with a push that grows smoothly from a small gap on. So the places at which the
/// ball touches the walls, and how they move with it, are continuous wherever the ball goes. With
/// the distance s_i of wall i, the place q of a ball at p is the solution of
///
///     q = p + sum_i push(s_i(q) - r) n_i(q).
class ElasticHold
{
public:
  static constexpr std::size_t MostWalls = CoupledPatches::MostWalls;

  /// `walls` are minima of the distance, near the ball's place `guessWorld`; those that are one at
  /// the end are kept once. Takes some evaluations of the surface for each. Does not allocate.
  ElasticHold(const TouchableRadialModel& surface, double ballRadius, const ClosestPoint* walls,
              std::size_t count, const Vector3& probeWorld, const Vector3& guessWorld) noexcept;

  const Vector3& CenterWorld() const noexcept { return this->Center; }
  /// Derivative of the place by the probe's.
  const Eigen::Matrix3d& Motion() const noexcept { return this->Moved; }
  const ClosestPoint* Walls() const noexcept { return this->Known.data(); }
  std::size_t WallCount() const noexcept { return this->Count; }
  /// Of the ball at the probe in a wall, along the wall's normal, mm; negative if it is apart.
  double DepthIn(const ClosestPoint& wall) const noexcept
  {
    return (this->Center - this->Probe).dot(wall.Normal) - this->GapTo(wall);
  }
  /// Between the held ball and a wall, mm.
  double GapTo(const ClosestPoint& wall) const noexcept { return wall.SignedDistance - this->Ball; }

private:
  struct Push
  {
    double Value; // mm
    double Slope; // by the gap
  };
  Push PushAt(double gap) const noexcept;
  void GoTo(const TouchableRadialModel& surface, const Vector3& place) noexcept;
  Vector3 Rest(Eigen::Matrix3d& slope) const noexcept;

  double Ball;  // its radius, mm
  double Reach; // the gap at which a push begins, mm
  Vector3 Probe;
  Vector3 Center;
  Eigen::Matrix3d Moved = Eigen::Matrix3d::Zero();
  std::array<ClosestPoint, MostWalls> Known{};
  std::size_t Count;
};
} // namespace palpate
