#pragma once

#include "Servo.h"
#include "SimulatedDevice.h"
#include "TouchScene.h"

#include <functional>

namespace palpate
{
/// How a simulated hand presses a scene to see whether it stays stable: for a second it presses and
/// lets go while it strokes, then it presses and holds still. The scene's frame has the tool begin
/// to touch at the device's origin.
struct StabilityTrial
{
  SimulatedSettings Device; ///< its path is the trial's
  ServoSettings Loop;
  Vector3 Outward = Vector3::UnitZ(); ///< unit vector out of the structure, device's frame
  double Depth = 3.0;                 ///< mm, of the hand's target
  double Frequency = 2.0;             ///< Hz, of pressing; whole periods a second
};

/// What such a trial showed.
struct StabilityObservation
{
  /// N mm: the least that structure and mechanism together had taken in, at any tick, since the
  /// contact of that tick began.
  double LeastEnergy = 0.0;
  /// mm, what the hand still went to and fro while it held still, in two stretches of 0.2 s: its
  /// way less the distance between the ends.
  double EarlierMotion = 0.0;
  double LaterMotion = 0.0;
  double Deepest = 0.0; ///< mm; 0 where nothing was touched
  SafetyFault Fault = SafetyFault::None;

  /// More energy came out than the roundings of friction where the hand turns within a step of its
  /// integration (less than 1e-6 N mm; a press takes in around 1 N mm).
  bool GaveOutEnergy() const noexcept { return !(this->LeastEnergy >= -1e-6); }
  /// A limit cycle: at rest it goes to and fro by more than 0.01 mm, which at 100 Hz is less than a
  /// micrometre each time, and in the second stretch not less than the hand's damping explains.
  bool Vibrated() const noexcept
  {
    return !(this->LaterMotion <= 0.01 || this->LaterMotion <= 0.9 * this->EarlierMotion);
  }
};

/// Presses in virtual time. Fails where the scene cannot be felt.
Status ObserveStability(const TouchScene& scene, const StabilityTrial& trial,
                        StabilityObservation& observation);

/// The border (N/mm, to one per cent) below which the scene's first structure, with everything else
/// as it is, passes `isStable`: from `likelyStable` on in steps of a quarter to the first stiffness
/// that fails, then by halving. 64 times `likelyStable` where none fails; 0 where even a 64th does.
/// Fails where the scene cannot be felt.
Status FindStableBorder(const TouchScene& scene, const StabilityTrial& trial, double likelyStable,
                        const std::function<bool(const StabilityObservation&)>& isStable,
                        double& border);
} // namespace palpate
