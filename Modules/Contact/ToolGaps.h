#pragma once

#include "PoseConstraints.h"
#include "ToolPose.h"
#include "ToolSkeleton.h"

#include <cstddef>
#include <utility>

namespace palpate
{
class FieldSolid;

/// What one structure leaves free for one tool of several balls, from step to step: remembers what
/// was near. One for each servo thread. Neither allocates nor locks after it was made.
class ToolGaps
{
public:
  virtual ~ToolGaps() = default;
  ToolGaps(const ToolGaps&) = delete;
  ToolGaps& operator=(const ToolGaps&) = delete;

  /// A new tick begins, with its whole work ahead.
  virtual void BeginTick() noexcept {}
  /// Adds a constraint for each wall that is RigidProxy::InTheWay of the tool at `pose`, with
  /// sources that are numbers of its own below 2^20. Returns how far (mm) the nearest of all is at
  /// least.
  virtual double Gather(const ToolPose& pose, PoseConstraints& limits) noexcept = 0;
  /// Whether no part of the tool at `pose` is inside by more than Slack.
  virtual bool IsFreeAt(const ToolPose& pose) noexcept = 0;
  static constexpr double Slack = 0.1; ///< mm, by which a proxy may be too deep
  /// Without the structure.
  virtual std::size_t Bytes() const noexcept = 0;
  /// As ContactTracker.
  virtual bool CanBeDrilled() const noexcept { return false; }
  virtual void UseSolid(const FieldSolid&) noexcept {}

protected:
  static constexpr double WallsWithin = 2.0; ///< mm from a ball; walls farther off are forgotten

  /// A plane near a ball of the tool.
  struct Wall
  {
    Vector3 Normal;         // unit, outwards, world
    double Gap = 0.0;       // mm from the ball
    std::size_t Number = 0; // of the ball's walls, from 0 to 7
  };

  ToolGaps(ToolSkeleton tool, const SurfaceFriction& friction)
      : Tool(std::move(tool)), Friction(friction)
  {
  }
  /// Adds a wall near a ball, if it is RigidProxy::InTheWay.
  void AddWall(const ToolPose& pose, const ToolSkeleton::Ball& ball, std::size_t ballNumber,
               const Wall& wall, PoseConstraints& limits) const noexcept;

private:
  ToolSkeleton Tool;
  SurfaceFriction Friction;
};
} // namespace palpate
