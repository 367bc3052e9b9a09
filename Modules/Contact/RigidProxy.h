#pragma once

#include "PoseConstraints.h"
#include "ToolPose.h"
#include "ToolSkeleton.h"
#include "ToolWrench.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace palpate
{
/// The pose of a stiff tool that follows a hand's as closely as it can without entering anything:
/// one god object for all structures, which may be touched in several places at once. Force and
/// torque are the gradient of one energy, k |shift|^2 / 2 + k L^2 angle^2 / 2 of hand and proxy
/// with the tool's gyration L, so that without friction nothing turns motion into energy.
class RigidProxy
{
public:
  static constexpr int StepsPerTick = 12;
  static constexpr double Stride = 0.25; ///< mm, of the farthest point, where something is near
  static constexpr double Margin = 1.0;  ///< mm: what is farther off is not near
  /// mm: what is farther off does not constrain a step, which may be a stride long.
  static constexpr double InTheWay = 0.5;
  /// rad in a tick, of a tool that touches: one that tips over an edge comes to rest in some ticks.
  static constexpr double FastestTurn = 0.02;

  explicit RigidProxy(const ToolSkeleton& tool) : RigidProxy(tool, tool.Gyration()) {}
  /// `gyration` (mm) instead of the tool's: how much a turn counts as a shift.
  RigidProxy(const ToolSkeleton& tool, double gyration)
      : TurnLength(gyration), Extent(tool.BoundingRadius())
  {
  }

  /// Begins where the tool is free.
  void Begin(const ToolPose& pose) noexcept
  {
    this->Now = pose;
    this->Solved.Clear();
  }
  /// Follows the hand as far as the steps of a tick lead. `gather(pose, constraints)` adds all that
  /// is in the way of the tool there, and returns how far (mm) the nearest of all is at least.
  /// Returns whether the proxy has arrived. Does not allocate.
  template <typename Gather>
  bool Follow(const ToolPose& hand, const Gather& gather) noexcept
  {
    double turned = 0.0;
    for (int step = 0; step < StepsPerTick; ++step)
    {
      this->Limits.Clear();
      const double nearest = gather(this->Now, this->Limits);
      if (this->Limits.Holds())
      {
        return false;
      }
      this->Limits.StartFrom(this->Solved);
      Twist twist = this->Limits.Solve(this->TowardsHand(hand), this->TurnLength);
      this->Solved = this->Limits;
      const double full = this->WayOf(twist);
      const double longest = this->LongestWay(nearest, twist, turned);
      if (longest <= 0.0)
      {
        return false;
      }
      this->KeepWithin(longest, twist);
      this->Move(twist);
      turned += twist.Turn.norm();
      if (full < Arrived || (step >= StepsToRest && full < Resting))
      {
        return true;
      }
    }
    return false;
  }

  const ToolPose& Pose() const noexcept { return this->Now; }
  double Gyration() const noexcept { return this->TurnLength; }
  /// Of the last step, with the multipliers that keep the whole way to the hand out of everything:
  /// the sum of their shifts is the proxy's place without the hand's, where it has arrived.
  const PoseConstraints& Constraints() const noexcept { return this->Solved; }
  /// For a coupling of `stiffness` (N/mm) between hand and proxy.
  ToolWrench WrenchOn(const ToolPose& hand, double stiffness) const noexcept;
  /// N mm: the energy of which it is the gradient.
  double EnergyOf(const ToolPose& hand, double stiffness) const noexcept;
  std::size_t ContactCount() const noexcept;

private:
  static constexpr double Arrived = 1e-6; // mm
  // Where the normal jumps, as from voxel to voxel, it may go to and fro by this much (mm).
  static constexpr double Resting = 5e-3;
  static constexpr int StepsToRest = 4;

  Twist TowardsHand(const ToolPose& hand) const noexcept;
  double WayOf(const Twist& twist) const noexcept
  {
    return twist.Shift.norm() + this->Extent * twist.Turn.norm();
  }
  double LongestWay(double nearest, const Twist& twist, double turned) const noexcept;
  void KeepWithin(double longest, Twist& twist) noexcept;
  void Move(const Twist& twist) noexcept;

  double TurnLength; // mm, see ToolSkeleton::Gyration
  double Extent;     // mm
  ToolPose Now;
  PoseConstraints Limits; // of a step
  PoseConstraints Solved;
};
} // namespace palpate
