#pragma once

#include "DeviceCapabilities.h"
#include "Servo.h"
#include "Status.h"
#include "TouchState.h"

#include <string>
#include <vector>

namespace palpate
{
/// Of a session: all that its forces followed from, but the scenes.
struct TouchSession
{
  ServoSettings Settings;
  /// Those that forces depend on: MaximumForce, MaximumDamping, Damping, Friction,
  /// GravityCompensation, and LeastRate, which is its Rate where it was read from a file.
  DeviceCapabilities Device;
};

/// A recorded session. Ticks follow each other without a gap, from the servo's first one.
struct TouchRecording
{
  TouchSession Session;
  std::vector<TouchState> Ticks;
  bool WasCutOff = false; ///< the file ended within a tick, which is left out
};

/// Reads a file that a TouchRecorder wrote, or the part of one that was not finished (its name ends
/// with .part). Refuses, with `recording` untouched, what is none and what lacks ticks.
Status ReadTouchRecording(const std::string& path, TouchRecording& recording);
} // namespace palpate
