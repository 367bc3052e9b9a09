#pragma once

#include "PalpateStudyModule.h"
#include "SurfaceTouch.h"

#include <filesystem>
#include <string>
#include <vector>

namespace palpate
{
/// Endings of files of touched points: .csv, .mrk.json, .fcsv, .touch.
PALPATESTUDY_EXPORT std::vector<std::string> TouchedPointsEndings();

/// Reads points that were touched on an organ (mm, patient LPS), of a standard deviation (mm)
/// unless the file says otherwise. 3D Slicer's markups (ReadMarkups): points of lists by
/// themselves, each curve as a stroke; its older .fcsv, from RAS too. A table, with a header and
/// any of CsvSeparator's separators: x, y, z or x_mm, y_mm, z_mm; where it has them nx, ny, nz (a
/// normal, empty for none), sd (mm), stroke (a number from 1) and outside (1: the organ does not
/// reach that far); of more than 16 MiB it is refused. A recorded touch: where a sphere of
/// `toolRadius` (mm) touched (TouchesOf). Throws InputError, naming the line, for what is not such
/// a file or has no points.
PALPATESTUDY_EXPORT std::vector<SurfaceTouch>
ReadTouchedPoints(const std::filesystem::path& file, double deviation, double toolRadius = 0.0);

/// Writes touches so that ReadTouchedPoints reads them, under AtomicFile's rules, by the ending:
/// .csv with all columns and full precision; .mrk.json with points and strokes alone. Throws
/// InputError, also for no touches, and for touches outside in .mrk.json, which has no place for
/// them.
PALPATESTUDY_EXPORT void WriteTouchedPoints(const std::filesystem::path& file,
                                            const std::vector<SurfaceTouch>& touches);
} // namespace palpate
