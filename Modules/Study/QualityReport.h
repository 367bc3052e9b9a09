#pragma once

#include "PalpateStudyModule.h"
#include "QualityMeasurement.h"
#include "SceneSettings.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// How far the measurement of one structure's presets is.
struct QualityLine
{
  int Id = 0;
  std::string Title;
  std::string Settings;                    ///< "harmonics of degree 8"
  std::optional<double> TickMicroseconds;  ///< mean, of its model alone; none: not measured
  std::optional<double> ErrorMillimeters;  ///< of the surface, mean
  std::string Presets;                     ///< what each would cost, one a line; empty without
  std::optional<double> MeasuringFraction; ///< while it is measured
  std::string Problem;                     ///< why it could not be measured; empty without
};

/// "harmonics of degree 8" of a structure touched so, "facets", "sub-voxel, cubic".
PALPATESTUDY_EXPORT std::string QualityText(const SceneStructure& structure);

/// A line with what was measured of a structure, null where nothing was.
PALPATESTUDY_EXPORT QualityLine MakeQualityLine(const SceneStructure& structure,
                                                const QualityMeasurement* measured);

/// "label 1: harmonics of degree 8, 0.31 µs, 0.12 mm".
PALPATESTUDY_EXPORT std::string TextOf(const QualityLine& line);

/// One sentence of numbers for the whole scene: the slowest tick and the largest error that are
/// expected, the tick that is measured now (µs, of everything a servo does; 0: nothing is touched),
/// and how many structures are still to be measured.
PALPATESTUDY_EXPORT std::string QualityNumbersText(const std::vector<QualityLine>& lines,
                                                   double measuredMicroseconds);
} // namespace palpate
