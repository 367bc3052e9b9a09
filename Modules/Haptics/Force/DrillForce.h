#pragma once

#include "Vector3.h"

namespace palpate
{
/// Response of a material to a drill.
struct DrillLaw
{
  /// mm of depth per N of push and m of rubbing distance of the tool's surface; 0: never removed.
  double Wear = 0.0;
  double Drag = 0.0; ///< s/mm: resistance to motion along the surface per N of push
  double Vibration =
      0.0; ///< fraction of the push, 0 to 1, that oscillates while material is removed
};

/// Motion of a running drill.
struct DrillMotion
{
  double Radius = 0.0;               ///< mm, of the cutting tool
  double Turns = 0.0;                ///< revolutions per second
  double VibrationFrequency = 120.0; ///< Hz; well below half the tick rate
};

/// Speed (mm/s) at which a surface wears under a push (N): proportional to the push and to the
/// tool's rubbing speed (Preston, J. Society of Glass Technology 11, 1927).
double FeedRate(const DrillLaw& law, const DrillMotion& motion, double push) noexcept;

/// Force (N) of drilling in addition to the contact force: drag against motion along the surface,
/// which never exceeds the push and is passive, and a vibration along the normal in proportion to
/// removal: full if the surface recedes by the full `FeedRate`, none if nothing is removed.
/// Together with the push it never pulls.
///
/// `normal` is the surface's outward unit normal, `velocity` the hand's (mm/s), `recession` the
/// actual speed of the surface (mm/s), `time` the tick's (s), all in the frame of the force.
Vector3 DrillForce(const DrillLaw& law, const DrillMotion& motion, double push,
                   const Vector3& normal, const Vector3& velocity, double recession,
                   double time) noexcept;
} // namespace palpate
