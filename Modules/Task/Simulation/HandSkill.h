#pragma once

#include "PalpateTaskModule.h"
#include "Vector3.h"

#include <random>
#include <string>
#include <vector>

namespace palpate
{
/// How well a simulated hand moves, sees and feels. What was published is said at each value;
/// Documentation/HowTo/Task.md has the sources, and which values are assumed.
struct PALPATETASK_EXPORT HandSkill
{
  /// Tremor of a free hand at rest, RMS along the device's axes, mm, between 6 and 12 Hz.
  Vector3 Tremor = Vector3::Zero();
  double TremorPerNewton = 0.0;   ///< mm RMS more per N of force (linear: Sutton and Sykes 1967)
  double MovementDeviation = 0.0; ///< of a movement's end, parts of its length (signal-dependent)
  double AimDeviation = 0.0;      ///< mm, of a place on a surface as it is seen, each axis along it
  double SightDepthDeviation = 0.0; ///< mm, of a seen place's depth
  double PressDeviation = 0.0;      ///< mm, of the depth of a press
  double DriftDeviation = 0.0;      ///< mm, while following a line
  double SeenErrorDeviation = 0.0;  ///< mm, of a surface's distance from an edge as it is seen
  double PullDeviation = 0.0;       ///< mm, of where a surface is let go
  double SeenTurnDeviation = 0.0;   ///< degrees, of a body's turn as it is seen, each axis
  double PerceptDeviation = 0.0;    ///< of a felt force, just noticeable differences (7 %)
  double Speed = 60.0;              ///< mm/s, of movements
  double FollowingSpeed = 20.0;     ///< mm/s, along lines
  double TouchDelay = 0.15;         ///< s, from a force to the reaction to it
  double SightDelay = 0.30;         ///< s, from what is seen to the reaction to it
  int Sweeps = 2;                   ///< presses of each place of a search
  int Returns = 6;                  ///< presses of a suspicious place

  static HandSkill Exact() { return {}; }
  static HandSkill Novice();
  static HandSkill Expert();
  static const std::vector<std::string>& Levels(); ///< "novice", "expert"
  /// Throws InputError for an unknown level.
  static HandSkill OfLevel(const std::string& level);

  /// One person of this level: all errors are larger or smaller by one factor, log-normal with a
  /// standard deviation of 20 % (assumed).
  HandSkill OnePerson(std::mt19937_64& random) const;
};
} // namespace palpate
