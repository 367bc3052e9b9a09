#pragma once

#include "Clock.h"
#include "PalpateStudyModule.h"
#include "Progress.h"
#include "QualityPreset.h"
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
} // namespace palpate
