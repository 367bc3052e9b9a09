#pragma once

#include "PoseConstraints.h"
#include "ToolPose.h"
#include "ToolSkeleton.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace palpate
{
/// The distance of a point from what may not be entered (mm, negative inside), and the outward unit
/// normal there.
struct SurfaceGap
{
  double Distance = 0.0;
  Vector3 Normal = Vector3::UnitZ();
};

/// What a hand feels of a tool that is held up: N, and N mm about the tool's origin.
struct ToolWrench
{
  Vector3 Force = Vector3::Zero();
  Vector3 Torque = Vector3::Zero();
};

/// The pose of a stiff tool that follows a hand's as closely as it can without entering anything:
/// one god object for all structures, which may be touched in several places at once. Force and
/// torque are the gradient of one energy, k |shift|^2 / 2 + k L^2 angle^2 / 2 of hand and proxy
/// with the tool's gyration L, so that nothing turns motion into energy.
class RigidProxy
{
public:
  static constexpr int StepsPerTick = 24;
  static constexpr double Stride = 0.25; ///< mm, of the farthest point, where something is near
  static constexpr double Margin = 1.0;  ///< mm: what is farther off does not constrain a step

  explicit RigidProxy(ToolSkeleton tool)
      : Tool(std::move(tool)), Pushes(this->Tool.Balls().size(), 0.0)
  {
  }

  /// Begins where the tool is free.
  void Begin(const ToolPose& pose) noexcept
  {
    this->Now = pose;
    std::fill(this->Pushes.begin(), this->Pushes.end(), 0.0);
  }
  /// Follows the hand as far as the steps of a tick lead. `gapAt` gives the SurfaceGap of a point
  /// in the world, which it knows within Margin; it is asked for each ball in each step. Returns
  /// whether the proxy has arrived. Does not allocate.
  template <typename GapAt>
  bool Follow(const ToolPose& hand, const GapAt& gapAt) noexcept
  {
    for (int step = 0; step < StepsPerTick; ++step)
    {
      const double nearest = this->Constrain(gapAt);
      Twist twist = this->Limits.Solve(this->TowardsHand(hand), this->Tool.Gyration());
      this->KeepPushes();
      // As far as nothing can be, since a distance changes by no more than the way; and short
      // enough for planes to stand for surfaces. What the last step left too deep is mended in
      // full.
      const double most = std::max(Stride, 0.9 * (nearest - Margin));
      const double way = this->WayOf(twist);
      if (way > most)
      {
        this->Limits.ForgetPushes();
        twist = this->Limits.Solve({most / way * twist.Shift, most / way * twist.Turn},
                                   this->Tool.Gyration());
      }
      this->Move(twist);
      if (this->WayOf(twist) < Arrived)
      {
        return true;
      }
    }
    return false;
  }

  const ToolPose& Pose() const noexcept { return this->Now; }
  /// For a coupling of `stiffness` (N/mm) between hand and proxy.
  ToolWrench WrenchOn(const ToolPose& hand, double stiffness) const noexcept;
  /// N mm: the energy of which it is the gradient.
  double EnergyOf(const ToolPose& hand, double stiffness) const noexcept;
  std::size_t ContactCount() const noexcept;

private:
  static constexpr double Arrived = 1e-6; // mm

  template <typename GapAt>
  double Constrain(const GapAt& gapAt) noexcept
  {
    this->Limits.Clear();
    double nearest = 1e300;
    for (std::size_t n = 0; n < this->Tool.Balls().size(); ++n)
    {
      const ToolSkeleton::Ball& ball = this->Tool.Balls()[n];
      const Vector3 arm = this->Now.Orientation * ball.Center;
      const SurfaceGap gap = gapAt(Vector3(this->Now.PositionWorld + arm));
      const double left = gap.Distance - ball.Radius;
      nearest = std::min(nearest, left);
      if (left < Margin)
      {
        this->Limits.Add({arm, gap.Normal, left, this->Pushes[n], n});
      }
    }
    return nearest;
  }
  Twist TowardsHand(const ToolPose& hand) const noexcept;
  double WayOf(const Twist& twist) const noexcept
  {
    return twist.Shift.norm() + this->Tool.BoundingRadius() * twist.Turn.norm();
  }
  void KeepPushes() noexcept;
  void Move(const Twist& twist) noexcept;

  ToolSkeleton Tool;
  ToolPose Now;
  PoseConstraints Limits;
  std::vector<double> Pushes; // mm, of each ball
};
} // namespace palpate
