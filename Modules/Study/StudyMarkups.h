#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>
#include <vector>

namespace palpate
{
/// The content of a markups file; mm, patient LPS.
struct StudyMarkups
{
  bool IsEmpty() const { return this->Landmarks.empty() && this->Measurements.empty(); }

  std::vector<StudyLandmark> Landmarks;
  std::vector<StudyMeasurement> Measurements; ///< none is open
};

/// Of a state, without its open measurement.
PALPATESTUDY_EXPORT StudyMarkups MarkupsOf(const StudyState& state);

/// Whether a file is one of 3D Slicer's markups, by its name.
PALPATESTUDY_EXPORT bool IsMarkupsFile(const std::filesystem::path& file);

/// Writes landmarks and measurements (mm, patient LPS) under AtomicFile's rules, by the ending.
/// .mrk.json: 3D Slicer's markups, schema 1.0.3: one list of points, and a Line, Angle, Curve or
/// Plane for each measurement; a curve along a surface has the points of its path, which 3D Slicer
/// draws as a spline, as any curve. .csv: kind,name,point,x_mm,y_mm,z_mm,value,unit, a line for
/// each point. Numbers have full precision. Throws InputError, also if there is nothing to write.
PALPATESTUDY_EXPORT void WriteMarkups(const std::filesystem::path& path,
                                      const StudyMarkups& markups);
} // namespace palpate
