#pragma once

#include "DeviceCapabilities.h"
#include "Servo.h"
#include "Status.h"
#include "TouchState.h"

#include <string>
#include <vector>

namespace palpate
{
/// A session: everything that determines its forces, except for the scenes.
struct RecordedSession
{
  ServoSettings Settings;
  /// Only the members that forces depend on: MaximumForce, MaximumTorque, MaximumDamping, Damping,
  /// Friction, GravityCompensation, HasMotors, and LeastRate, which is its Rate if it was read from
  /// a file.
  DeviceCapabilities Device;
};

/// A recorded session. Ticks are contiguous, starting with the servo's first one.
struct TouchRecording
{
  RecordedSession Session;
  std::vector<TouchState> Ticks;
  bool WasCutOff = false; ///< the file ended within a tick, which is omitted
  bool HasTorques = true; ///< false for a file of an older version, without orientations too
};

/// Reads a file that a TouchRecorder wrote, or the part of an unfinished one (its name ends with
/// .part). Fails, with `recording` unchanged, for other files and if ticks are missing.
Status ReadTouchRecording(const std::string& path, TouchRecording& recording);
} // namespace palpate
