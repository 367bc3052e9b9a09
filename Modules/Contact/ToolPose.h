#pragma once

#include "Vector3.h"

namespace palpate
{
/// Pose of a tool: world is patient LPS, mm.
struct ToolPose
{
  Vector3 PositionWorld = Vector3::Zero(); ///< of the origin of the tool's frame
  /// From the tool's frame to the world; a unit quaternion.
  Eigen::Quaterniond Orientation = Eigen::Quaterniond::Identity();

  /// False if not finite, or too large to be squared.
  bool IsUsable() const noexcept
  {
    constexpr double Farthest = 1e100;
    return this->PositionWorld.lpNorm<Eigen::Infinity>() <= Farthest &&
           this->PositionWorld.allFinite() && this->Orientation.coeffs().allFinite();
  }
};
} // namespace palpate
