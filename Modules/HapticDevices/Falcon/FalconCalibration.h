#pragma once

#include "FalconGeometry.h"
#include "Status.h"

#include <string>

namespace palpate
{
/// What may differ from one Falcon to the next, or between published sources. The defaults are
/// published values.
struct FalconCalibration
{
  FalconGeometry Geometry;
  /// Motor values for a torque of 1 N mm at a thigh. 6.6 follows from published constants of motor
  /// and gear and gives the maker's 9 N; a widespread library has 10, which gives 6 N. To be
  /// measured with a weight.
  double CountsPerNewtonMillimeter = 6.6;
  /// Of the handle (kg), whose weight the motors then carry; 0: none.
  double CarriedMass = 0.0;
};

/// Refuses lengths and scales that are no positive numbers, and lengths with which no leg reaches
/// the middle of the workspace.
Status Check(const FalconCalibration& calibration);

/// The text of a calibration file: a line "palpate-falcon-calibration 1", then a line for each
/// number, its name and value; lengths in mm, angles in degrees, mass in kg. What is left out keeps
/// its default; `#` begins a remark.
std::string TextOf(const FalconCalibration& calibration);
/// `name` is what the sentence calls the text where it is refused.
Status ParseCalibration(const std::string& text, const std::string& name,
                        FalconCalibration& calibration);
Status ReadCalibration(const std::string& path, FalconCalibration& calibration);
} // namespace palpate
