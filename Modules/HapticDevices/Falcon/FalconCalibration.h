#pragma once

#include "FalconGeometry.h"
#include "Status.h"

#include <string>

namespace palpate
{
/// Properties that may differ between devices, or between published sources. The defaults are
/// published values.
struct FalconCalibration
{
  FalconGeometry Geometry;
  /// Motor values for a torque of 1 N mm at a thigh. 6.6 follows from published constants of motor
  /// and gear and gives the manufacturer's 9 N; a widespread library has 10, which gives 6 N. To be
  /// measured with a weight.
  double CountsPerNewtonMillimeter = 6.6;
  /// Mass (kg) of the handle, whose weight the motors then compensate; 0: none.
  double CarriedMass = 0.0;
};

/// Fails for lengths and scales that are not positive numbers, and for lengths with which no leg
/// reaches the centre of the workspace.
Status Check(const FalconCalibration& calibration);

/// Parses a calibration file: a line "palpate-falcon-calibration 1", then one line per number,
/// with its name and value; lengths in mm, angles in degrees, mass in kg. Omitted numbers keep
/// their defaults; `#` starts a comment. `name` denotes the text in error messages.
Status ParseCalibration(const std::string& text, const std::string& name,
                        FalconCalibration& calibration);
Status ReadCalibration(const std::string& path, FalconCalibration& calibration);
} // namespace palpate
