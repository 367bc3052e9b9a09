#pragma once

#include "PoseConstraints.h"
#include "ToolPose.h"

namespace palpate
{
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
  /// Adds a constraint for each wall within RigidProxy::Margin of the tool at `pose`, with sources
  /// that are numbers of its own below 2^20. Returns how far (mm) the nearest of all is at least.
  virtual double Gather(const ToolPose& pose, PoseConstraints& limits) noexcept = 0;
  /// Whether no part of the tool at `pose` is inside by more than Slack.
  virtual bool IsFreeAt(const ToolPose& pose) noexcept = 0;
  static constexpr double Slack = 0.1; ///< mm, by which a proxy may be too deep

protected:
  static constexpr std::size_t SourcesOfPart = 8; // of a ball: more than it has walls

  ToolGaps() = default;
};
} // namespace palpate
