#include "QualityReport.h"

#include "DecimalText.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr double Micro = 1e-3; // us in a ns

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
            (row.IsFelt() ? Microseconds(Micro * row.TickMean) + ", " + Millimeters(row.SurfaceMean)
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
    line.TickMicroseconds = Micro * row->TickMean;
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
