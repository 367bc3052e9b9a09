#pragma once

#include "Vector3.h"

#include <array>

namespace palpate
{
/// Follows the measured orientation of a tool at a limited rate, so that a glitch, or a tracker
/// that comes back, does not throw a long tool through a scene.
class TurnLimit
{
public:
  /// rad/s; wrists turn at less than 30.
  static constexpr double MostTurn = 40.0;

  /// Replaces `orientation` (x, y, z, w; unit) by what is reached after `period` (s) on the shorter
  /// way to it: unit and continuous, so that q after -q is no turn. The first one after Reset, and
  /// what is within the limit, stays as it is but for its sign.
  void Follow(double period, std::array<double, 4>& orientation) noexcept;
  void Reset() noexcept { this->HasLast = false; }

private:
  Eigen::Quaterniond Last = Eigen::Quaterniond::Identity();
  bool HasLast = false;
};
} // namespace palpate
