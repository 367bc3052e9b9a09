#include "QualityMeasurement.h"

#include "TradeAdvice.h"
#include "TradeBench.h"
#include "TradeModels.h"

#include <algorithm>

namespace palpate
{
namespace
{
// A few strokes from all sides. Presets differ by far more than the next strokes would change.
constexpr double PathSeconds = 1.0;
constexpr int Runs = 3;

bool IsMeasured(const TradeRow& row)
{
  return row.IsFelt() && row.TickRare > 0.0 && row.SurfaceMean >= 0.0;
}

} // namespace

QualityMeasurement MeasureQuality(const TradeSource& source, const TouchToolSettings& tool,
                                  const Clock& clock, const ProgressFunction& progress)
{
  TradeBench::Settings settings;
  settings.Tool = tool;
  settings.Path.Seconds = PathSeconds;
  settings.Runs = Runs;
  TradeBench bench(source, settings, clock);
  int highest = 0;
  for (const TradeCandidate& candidate : bench.Candidates(progress))
  {
    const bool isHarmonics = candidate.Setting.Representation == TouchRepresentation::Harmonics;
    highest = isHarmonics ? std::max(highest, candidate.Setting.Degree) : highest;
  }
  std::vector<TradeCandidate> presets;
  for (int preset = 0; preset < QualityPresetCount; ++preset)
  {
    TradeSetting setting = SettingOfPreset(preset, tool);
    setting.Degree = highest > 0 ? std::min(setting.Degree, highest) : setting.Degree;
    presets.push_back({setting, TradeKnob::Representation});
  }
  QualityMeasurement measured;
  measured.Presets = MeasureTrade(bench, presets, progress);
  return measured;
}

int RecommendedPreset(const QualityMeasurement& measured, double rate)
{
  const TradeAdvice advice = AdviseOn(measured.Presets, std::nullopt, rate);
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
