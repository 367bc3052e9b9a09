#include "StudyDialReport.h"

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

std::string RungsText(const StudyTrade& trade)
{
  std::string text;
  for (const TradeRow& row : trade.Rungs)
  {
    const bool isMeasured = row.IsFelt();
    text += (text.empty() ? "" : "\n") + Describe(row.Setting) + ": " +
            (isMeasured ? Microseconds(Micro * row.TickMean) + ", " + Millimeters(row.SurfaceMean)
                        : "refused");
  }
  return text;
}

StudyDialLine LineOf(const StudyState& state, const StudyStructure& structure,
                     const StudyPipeline& pipeline)
{
  const auto trade = pipeline.Newest<StudyTrade>(StudyStep::Trade, structure.Label);
  const StudyFeel feel = FeelOf(state, structure, trade.get());
  StudyDialLine line;
  line.Label = structure.Label;
  line.Title = TitleOf(structure);
  // What came of it is said by the contact: harmonics may have been refused.
  const auto contact = pipeline.Newest<TouchContact>(StudyStep::Touch, structure.Label);
  const bool isReplaced = contact != nullptr && contact->Looks.Field != nullptr &&
                          feel.Representation == TouchRepresentation::Automatic;
  line.Settings = isReplaced ? NameOf(StudyDial::SubVoxelLinear) : Describe(feel);
  const TradeRow* row = trade != nullptr ? RowOf(*trade, feel.Rung) : nullptr;
  if (row != nullptr)
  {
    line.TickMicroseconds = Micro * row->TickMean;
    line.ErrorMillimeters = row->SurfaceMean;
  }
  line.Rungs = trade != nullptr ? RungsText(*trade) : std::string();
  const StudyStepState step = pipeline.StateOf(StudyStep::Trade, structure.Label);
  if (step.Is == StudyStepState::Kind::Running || step.Is == StudyStepState::Kind::NeedsUpdate)
  {
    line.MeasuringFraction = step.Fraction;
  }
  line.Problem = step.Is == StudyStepState::Kind::Failed ? step.Sentence : std::string();
  return line;
}

// The largest of what is known; empty where nothing is.
std::optional<double> Largest(const std::vector<StudyDialLine>& lines,
                              std::optional<double> StudyDialLine::*what)
{
  std::optional<double> largest;
  for (const StudyDialLine& line : lines)
  {
    if (line.*what)
    {
      largest = std::max(largest.value_or(0.0), *(line.*what));
    }
  }
  return largest;
}
} // namespace

std::vector<StudyDialLine> DialLinesOf(const StudyState& state, const StudyPipeline& pipeline)
{
  std::vector<StudyDialLine> lines;
  for (const StudyStructure& structure : state.Structures)
  {
    if (structure.IsTouchable)
    {
      lines.push_back(LineOf(state, structure, pipeline));
    }
  }
  return lines;
}

std::string TextOf(const StudyDialLine& line)
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

std::string DialNumbersText(const std::vector<StudyDialLine>& lines, double measuredMicroseconds)
{
  const auto tick = Largest(lines, &StudyDialLine::TickMicroseconds);
  const auto error = Largest(lines, &StudyDialLine::ErrorMillimeters);
  const std::string expected = tick ? Microseconds(*tick) + " expected" : std::string();
  const std::string measured =
      measuredMicroseconds > 0.0 ? Microseconds(measuredMicroseconds) + " measured" : std::string();
  const std::string both = expected + (expected.empty() || measured.empty() ? "" : ", ") + measured;
  const auto left =
      std::count_if(lines.begin(), lines.end(),
                    [](const StudyDialLine& line) { return line.MeasuringFraction.has_value(); });
  return "Tick: " + (both.empty() ? "not known yet" : both) +
         ". Error: " + (error ? Millimeters(*error) + " expected" : "not known yet") + "." +
         (left > 0 ? " Measuring: " + std::to_string(left) + " to go." : "");
}
} // namespace palpate
