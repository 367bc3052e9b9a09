#pragma once

#include "Vector3.h"

namespace palpate
{
/// Lengths (mm) and angles (rad) of a Falcon's mechanism, three equal legs as in Stamper's
/// manipulator of three translations with one more offset (L.-W. Tsai and R. Stamper, "A parallel
/// manipulator with only translational degrees of freedom", University of Maryland T.R. 97-72).
///
/// The defaults are the most widely used published ones. Others differ by millimetres (a thigh's
/// base at 36.6 or 37.2 mm, a home angle of 40 or 50 degrees), so positions of an uncalibrated
/// device have this uncertainty.
struct FalconGeometry
{
  double Thigh = 60.0;               ///< base joint to knee
  double Shin = 102.5;               ///< the parallelogram's length
  double KneeOffset = 11.25;         ///< of the shin from the knee
  double AnkleOffset = 11.25;        ///< of the shin from the platform's joint
  double PlatformRadial = 14.43;     ///< of the platform's joint from its centre
  double PlatformTangential = -25.0; ///< likewise
  double BaseRadial = 40.0;          ///< of the base joint from the base's centre
  double BaseTangential = -23.09;    ///< likewise

  /// Directions of the legs, seen from the user, from +x to +y: top, right, lower left.
  Vector3 LegDirections = Vector3(105.0, -15.0, -135.0) * (M_PI / 180.0);
  /// Angles of the thighs at count 0 of homed encoders.
  Vector3 HomeAngles = Vector3::Constant(35.0 * M_PI / 180.0);
  /// 1280 counts per turn of a capstan of 14.25 mm on a sector of 110 mm.
  double AnglePerCount = 2.0 * M_PI / 1280.0 * (14.25 / 110.0);
  /// Height of the centre of the workspace above the base.
  double CenterHeight = 125.0;
  /// Limits of the thighs' angles; housing and stops are tighter.
  double LowestAngle = -30.0 * M_PI / 180.0;
  double HighestAngle = 100.0 * M_PI / 180.0;
};
} // namespace palpate
