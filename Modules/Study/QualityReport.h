#pragma once

#include "Clock.h"
#include "PalpateStudyModule.h"
#include "Progress.h"
#include "QualityPreset.h"
#include "SceneSettings.h"
#include "TradeRow.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// The cost and the accuracy of each quality preset at one structure.
struct QualityMeasurement
{
  std::vector<TradeRow> Presets; ///< in order; only degrees that the structure supports
};

/// Identifies all settings of the measurement of a structure's presets, a label.
PALPATESTUDY_EXPORT std::string QualityKey(const SceneSettings& scene,
                                           const SceneStructure& structure);

/// Measures every preset at a label of a scene with short strokes, timed by `clock`. Throws
/// InputError if the tool cannot touch it at all, FilterError and Cancelled.
PALPATESTUDY_EXPORT QualityMeasurement MeasureQuality(const SceneSettings& scene,
                                                      const SceneStructure& structure,
                                                      const Clock& clock,
                                                      const ProgressFunction& progress);

/// The preset recommended by the trade-off (AdviseOn) for a servo's rate (Hz); -1 if none was
/// measured.
PALPATESTUDY_EXPORT int RecommendedPreset(const QualityMeasurement& measured, double rate);

/// The row of a preset, or of the sub-voxel field that replaces harmonics if they do not fit the
/// structure. Null if neither was measured.
PALPATESTUDY_EXPORT const TradeRow* RowOf(const QualityMeasurement& measured, int preset);

/// Progress and results of measuring one structure's presets.
struct QualityLine
{
  int Id = 0;
  std::string Title;
  std::string Settings;                   ///< "harmonics of degree 8"
  std::optional<double> TickMicroseconds; ///< mean, of its contact model alone; none: not measured
  std::optional<double> ErrorMillimeters; ///< of the surface, mean
  std::string Presets; ///< times and errors of all presets, one per line; may be empty
  std::optional<double> MeasuringFraction; ///< while measuring
  std::string Problem;                     ///< why it could not be measured; may be empty
};

/// The settings of a structure's touch: "harmonics of degree 8", "facets", "sub-voxel, cubic".
PALPATESTUDY_EXPORT std::string QualityText(const SceneStructure& structure);

/// Makes the line of a structure; `measured` is null if there is no measurement.
PALPATESTUDY_EXPORT QualityLine MakeQualityLine(const SceneStructure& structure,
                                                const QualityMeasurement* measured);

/// "label 1: harmonics of degree 8, 0.31 µs, 0.12 mm".
PALPATESTUDY_EXPORT std::string TextOf(const QualityLine& line);

/// Numbers for the whole scene as one line: the expected slowest tick and largest error, the tick
/// measured now (µs, all of a servo's work; 0: touch is off), and the number of structures yet to
/// be measured.
PALPATESTUDY_EXPORT std::string QualityNumbersText(const std::vector<QualityLine>& lines,
                                                   double measuredMicroseconds);
} // namespace palpate
