#pragma once

#include "StudyMarkups.h"

namespace palpate
{
/// Reads 3D Slicer's markups (.mrk.json, schemas 1.0.0 to 1.0.3) of types Fiducial, Line, Angle,
/// Curve, ClosedCurve and Plane, from LPS or RAS, mm or um, to LPS, mm. Points that were not
/// placed, lines and angles without all of their points, and other types are left out. A closed
/// curve ends where it begins; a plane that is given by its normal gets three points 10 mm apart.
/// Throws InputError for files of more than 16 MiB or 2,000 landmarks and measurements, positions
/// beyond 1e6 mm, other units or frames, and files with nothing to read.
PALPATESTUDY_EXPORT StudyMarkups ReadMarkups(const std::filesystem::path& path);
} // namespace palpate
