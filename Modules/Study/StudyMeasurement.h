#pragma once

#include "LengthText.h"
#include "PalpateStudyModule.h"
#include "Vector3.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What is measured.
enum class MeasurementKind
{
  Line,         ///< distance of two points
  Angle,        ///< at the second of three points
  Curve,        ///< length of a line through points
  SurfaceCurve, ///< length of a line through points, along a surface
  Plane,        ///< through three points
  Gap,          ///< smallest distance of two structures
  Thickness     ///< from a surface along its normal to the opposite wall
};
constexpr int MeasurementKindCount = 7;

/// A measurement that is placed point by point; mm, patient LPS. What was found on surfaces is
/// part of it: its value does not change with them.
struct StudyMeasurement
{
  MeasurementKind Kind = MeasurementKind::Line;
  std::string Name;
  std::vector<Vector3>
      PointsWorld;                ///< as placed; of a gap or a thickness, the ends that were found
  std::vector<Vector3> PathWorld; ///< of a surface curve, the path through its points
  /// mm, of that path: on a model, whose points it connects; 0: the length of its line.
  double PathLength = 0.0;
  int StructureId = 0; ///< on whose surface its first point is; 0: on none
  bool IsOpen = false; ///< the next point of this kind is added to it

  /// The line that is drawn and measured.
  const std::vector<Vector3>& Line() const
  {
    return this->PathWorld.empty() ? this->PointsWorld : this->PathWorld;
  }
};

PALPATESTUDY_EXPORT bool operator==(const StudyMeasurement& a, const StudyMeasurement& b);

/// "Line", "Angle", ...
PALPATESTUDY_EXPORT const char* NameOf(MeasurementKind kind);
/// "mm", "deg", or empty.
PALPATESTUDY_EXPORT const char* UnitOf(MeasurementKind kind);
/// Number of points that complete it; 0 for curves, which the user ends.
PALPATESTUDY_EXPORT std::size_t PointCountOf(MeasurementKind kind);
/// Whether it has the number of points that its kind and IsOpen allow.
PALPATESTUDY_EXPORT bool HasValidPoints(const StudyMeasurement& measurement);

/// Length in mm, or angle in degrees, of the points so far; none for planes and for too few points.
PALPATESTUDY_EXPORT std::optional<double> ValueOf(const StudyMeasurement& measurement);
/// The same as text, such as "12.3 mm"; empty if there is none.
PALPATESTUDY_EXPORT std::string ValueText(const StudyMeasurement& measurement,
                                          LengthUnit unit = LengthUnit::Millimeter);
/// Where its value is shown; it must have a point.
PALPATESTUDY_EXPORT Vector3 LabelPlaceOf(const StudyMeasurement& measurement);
} // namespace palpate
