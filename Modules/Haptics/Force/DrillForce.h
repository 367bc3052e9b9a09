#pragma once

#include "Vector3.h"

namespace palpate
{
/// How a material gives way to a drill.
struct DrillLaw
{
  /// mm of depth for each N of push and each m that the tool's surface rubs by; 0: never removed.
  double Wear = 0.0;
  double Drag = 0.0;      ///< s/mm: resistance to motion along the surface, a N of push
  double Vibration = 0.0; ///< part of the push, 0 to 1, that swings while material goes away
};

/// How a drill runs.
struct DrillMotion
{
  double Radius = 0.0;               ///< mm, at which the tool cuts
  double Turns = 0.0;                ///< a second
  double VibrationFrequency = 120.0; ///< Hz; well below half the rate of ticks
};

/// How fast (mm/s) a surface wears away under a push (N): in proportion to the push and to the
/// speed at which the tool rubs (Preston, J. Society of Glass Technology 11, 1927).
double FeedRate(const DrillLaw& law, const DrillMotion& motion, double push) noexcept;

/// What a hand feels of drilling beside the contact's own force (N): drag against its motion along
/// the surface, which never exceeds the push and gives out no energy, and a swing along the normal
/// that is there as far as material goes away: all of it where the surface recedes by the full
/// `FeedRate`, none where nothing is removed. Together with the push it never pulls.
///
/// `normal` is the surface's outward unit normal, `velocity` the hand's (mm/s), `recession` how
/// fast the surface really recedes (mm/s), `time` the tick's (s), all in the frame of the force.
Vector3 DrillForce(const DrillLaw& law, const DrillMotion& motion, double push,
                   const Vector3& normal, const Vector3& velocity, double recession,
                   double time) noexcept;
} // namespace palpate
