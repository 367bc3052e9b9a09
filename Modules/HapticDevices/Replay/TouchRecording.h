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
  /// Those that forces depend on: MaximumForce, MaximumDamping, Damping, Friction, Rate.
  DeviceCapabilities Device;
};

/// A recorded session. Ticks follow each other without a gap, from the servo's first one.
struct TouchRecording
{
  TouchSession Session;
  std::vector<TouchState> Ticks;
};

/// Reads a file that a TouchRecorder wrote. Refuses, with `recording` untouched, what is none, what
/// was cut off, and what lacks ticks.
Status ReadTouchRecording(const std::string& path, TouchRecording& recording);
} // namespace palpate
