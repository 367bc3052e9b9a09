#pragma once

#include "MeasuredSurfaces.h"
#include "PalpateStudyModule.h"
#include "StudyState.h"

namespace palpate
{
/// A point that the user places, mm, patient LPS.
struct PlacedPoint
{
  Vector3 PointWorld = Vector3::Zero();
  int StructureId = 0; ///< which the tool touches; 0: the nearest one, if one is needed
};

/// How far from a surface (mm) a point may be placed that is meant to be on it.
constexpr double FarthestPlacing = 10.0;

/// The measurement that the next point is added to; null if the next one begins another.
PALPATESTUDY_EXPORT const StudyMeasurement* OpenMeasurement(const StudyState& state);

/// The measurement as it is with a point more. Fails where the surfaces do not allow it, and then
/// leaves it unchanged. A curve along a surface is measured on its triangles or its model.
PALPATESTUDY_EXPORT Status AddPoint(StudyMeasurement& measurement, const PlacedPoint& point,
                                    MeasuredSurfaces& surfaces, MeasuredSurfaces::PathOn on);

/// Adds a point to the open measurement of this kind, or begins one. An open one of another kind
/// ends: curves with two points stay, others go. A curve along a model is measured on it. Fails as
/// above, and then leaves the state unchanged.
PALPATESTUDY_EXPORT Status AddPoint(StudyState& state, MeasurementKind kind,
                                    const PlacedPoint& point, MeasuredSurfaces& surfaces);

/// Ends the open measurement as above. Returns whether there was one.
PALPATESTUDY_EXPORT bool EndMeasurement(StudyState& state);
} // namespace palpate
