#pragma once

#include <atomic>

/// What a test sets of a stand-in for a maker's library, and sees of it; exported as "StandIn".
struct StandInArm
{
  std::atomic<double> Place[3];     ///< in the library's own frame and unit
  std::atomic<double> Force[3];     ///< N, the last one displayed, likewise
  std::atomic<double> LargestForce; ///< N, of all
  std::atomic<double> Torque[3];    ///< in the library's own frame and unit, likewise
  std::atomic<double> LargestTorque;
  std::atomic<bool> Turns; ///< it has motors for torques
  std::atomic<int> Pushes; ///< steps with a force or a torque
  std::atomic<int> Buttons;
  std::atomic<int> Steps;
  std::atomic<bool> IsMissing; ///< no device is found
  std::atomic<bool> Fails;     ///< from the next step on
  std::atomic<bool> IsOpen;
};
