#pragma once

#include "PalpateStudyModule.h"
#include "StudyState.h"

#include <filesystem>

namespace palpate
{
/// Writes landmarks and distances (mm, patient LPS) under AtomicFile's rules, by the ending:
/// .mrk.json 3D Slicer's markups: one list of points, and a line for each distance; .csv
/// kind,name,x_mm,y_mm,z_mm,to_x_mm,to_y_mm,to_z_mm,length_mm, a line each. Numbers have full
/// precision. Throws InputError, also if there is nothing to write.
PALPATESTUDY_EXPORT void WriteMarkups(const std::filesystem::path& path,
                                      const std::vector<StudyLandmark>& landmarks,
                                      const std::vector<StudyDistance>& distances);
} // namespace palpate
