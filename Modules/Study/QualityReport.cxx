#include "QualityReport.h"

#include "DecimalText.h"
#include "FileStamp.h"
#include "FitSettingsJson.h"
#include "SceneReading.h"
#include "StructureTrade.h"
#include "TradeAdvice.h"
#include "Units.h"

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

std::string Microseconds(double number)
{
  return SignificantText(number, 2) + " \u00B5s";
}

std::string Millimeters(double number)
{
  return SignificantText(number, 2) + " mm";
}

std::string PresetsText(const QualityMeasurement& measured)
{
  std::string text;
  for (const TradeRow& row : measured.Presets)
  {
    text += (text.empty() ? "" : "\n") + Describe(row.Setting) + ": " +
            (row.IsFelt() ? Microseconds(MicrosecondsPerNanosecond * row.TickMean) + ", " +
                                Millimeters(row.SurfaceMean)
                          : "refused");
  }
  return text;
}

// The largest known value, if any.
std::optional<double> Largest(const std::vector<QualityLine>& lines,
                              std::optional<double> QualityLine::*what)
{
  std::optional<double> largest;
  for (const QualityLine& line : lines)
  {
    if (line.*what)
    {
      largest = std::max(largest.value_or(0.0), *(line.*what));
    }
  }
  return largest;
}
} // namespace

std::string QualityKey(const SceneSettings& scene, const SceneStructure& structure)
{
  const TouchToolSettings& tool = scene.Tool;
  return SceneKey(structure.File.string(), StampOf(structure.File), structure.Labels.front(),
                  structure.Smoothing, structure.Stiffness, FitSettingsJson(scene.Fit).dump(),
                  static_cast<int>(tool.Kind), tool.Radius, tool.Length, tool.SemiAxes.transpose(),
                  tool.File, tool.Points);
}

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

std::string QualityText(const SceneStructure& structure)
{
  if (structure.Representation == TouchRepresentation::ModelOrField ||
      structure.Representation == TouchRepresentation::Harmonics)
  {
    return "harmonics of degree " + std::to_string(structure.Degree);
  }
  if (structure.Representation == TouchRepresentation::SubVoxel)
  {
    return structure.Interpolation == FieldInterpolation::Trilinear ? "sub-voxel, linear"
                                                                    : "sub-voxel, cubic";
  }
  return RepresentationOf(structure).Label;
}

QualityLine MakeQualityLine(const SceneStructure& structure, const QualityMeasurement* measured)
{
  QualityLine line;
  line.Id = structure.Id;
  line.Title = TitleOf(structure);
  line.Settings = QualityText(structure);
  const TradeRow* row = measured != nullptr ? RowOf(*measured, PresetOf(structure)) : nullptr;
  if (row != nullptr)
  {
    line.TickMicroseconds = MicrosecondsPerNanosecond * row->TickMean;
    line.ErrorMillimeters = row->SurfaceMean;
  }
  line.Presets = measured != nullptr ? PresetsText(*measured) : std::string();
  return line;
}

std::string TextOf(const QualityLine& line)
{
  std::string text = line.Title + ": " + line.Settings;
  text += line.TickMicroseconds ? ", " + Microseconds(*line.TickMicroseconds) : "";
  text += line.ErrorMillimeters ? ", " + Millimeters(*line.ErrorMillimeters) : "";
  if (line.MeasuringFraction)
  {
    constexpr double Percent = 100.0;
    text += ", measuring (" + FixedText(Percent * *line.MeasuringFraction, 0) + " %)";
  }
  text += line.Problem.empty() ? "" : ", not measured: " + line.Problem;
  return text;
}

std::string QualityNumbersText(const std::vector<QualityLine>& lines, double measuredMicroseconds)
{
  const auto tick = Largest(lines, &QualityLine::TickMicroseconds);
  const auto error = Largest(lines, &QualityLine::ErrorMillimeters);
  const std::string expected = tick ? Microseconds(*tick) + " expected" : std::string();
  const std::string measured =
      measuredMicroseconds > 0.0 ? Microseconds(measuredMicroseconds) + " measured" : std::string();
  const std::string both = expected + (expected.empty() || measured.empty() ? "" : ", ") + measured;
  const auto left =
      std::count_if(lines.begin(), lines.end(),
                    [](const QualityLine& line) { return line.MeasuringFraction.has_value(); });
  return "Tick: " + (both.empty() ? "not known yet" : both) +
         ". Error: " + (error ? Millimeters(*error) + " expected" : "not known yet") + "." +
         (left > 0 ? " Measuring: " + std::to_string(left) + " to go." : "");
}
} // namespace palpate
