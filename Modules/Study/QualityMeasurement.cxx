#include "QualityMeasurement.h"

#include "StructureTrade.h"
#include "TradeAdvice.h"

#include <algorithm>

namespace palpate
{
namespace
{
// A few strokes from all sides; presets differ by far more than further strokes would change.
constexpr double PathSeconds = 1.0;
constexpr int Runs = 3;

bool IsMeasured(const TradeRow& row)
{
  return row.IsFelt() && row.TickRare > 0.0 && row.SurfaceMean >= 0.0;
}
} // namespace

QualityMeasurement MeasureQuality(const SceneSettings& scene, const SceneStructure& structure,
                                  const Clock& clock, const ProgressFunction& progress)
{
  StructureTrade::Settings settings;
  settings.Path.Seconds = PathSeconds;
  settings.Runs = Runs;
  StructureTrade trade(scene, structure, SceneRun(), settings, clock);
  const int highest = trade.HighestDegree(progress);
  std::vector<ContactSetting> presets;
  for (int preset = 0; preset < QualityPresetCount; ++preset)
  {
    // No fallback, so that a refusal gives a row.
    SceneStructure one = WithPreset(structure, preset);
    const bool isField = one.Representation == TouchRepresentation::SubVoxel;
    one.Representation = isField ? one.Representation : TouchRepresentation::Harmonics;
    one.Degree = highest > 0 ? std::min(one.Degree, highest) : one.Degree;
    presets.push_back({one, scene.Tool.Points});
  }
  return {trade.MeasureAll(presets, progress)};
}

int RecommendedPreset(const QualityMeasurement& measured, double rate)
{
  const TradeAdvice advice = AdviseOn(measured.Presets, rate);
  return advice.Row ? static_cast<int>(*advice.Row) : -1;
}

const TradeRow* RowOf(const QualityMeasurement& measured, int preset)
{
  constexpr int SubVoxelLinear = 4;
  for (const int one : {preset, SubVoxelLinear})
  {
    const auto index = static_cast<std::size_t>(one);
    if (one >= 0 && index < measured.Presets.size() && IsMeasured(measured.Presets[index]))
    {
      return &measured.Presets[index];
    }
  }
  return nullptr;
}
} // namespace palpate
