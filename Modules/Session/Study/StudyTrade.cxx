#include "StudyTrade.h"

#include "TradeBench.h"
#include "TradeModels.h"

#include "vtkImageData.h"

#include <algorithm>
#include <cmath>

namespace palpate
{
namespace
{
// A few strokes from all round. Rungs differ by far more than the next strokes would change.
constexpr double PathSeconds = 1.0;
constexpr int Runs = 3;

bool IsMeasured(const TradeRow& row)
{
  return row.IsFelt() && row.TickRare > 0.0 && row.SurfaceMean >= 0.0;
}

bool Fits(const TradeRow& row, double rate)
{
  constexpr double PartOfPeriod = 1.0 / 3.0;
  return 1e-9 * row.TickRare * rate <= PartOfPeriod;
}

bool IsTrueEnough(const TradeRow& row, double voxel)
{
  const bool isAsVoxels = row.SurfaceMean <= voxel / std::sqrt(12.0);
  const bool isAsHands =
      row.NoticeableMean <= 1.0 && row.DirectionMean <= TradeThresholds::NoticeableDegrees;
  return isAsVoxels || isAsHands;
}

double LargestSpacing(const TradeSource& source)
{
  const auto* mask = std::get_if<TradeSource::Mask>(&source.Is);
  if (mask == nullptr)
  {
    return 0.0;
  }
  const double* spacing =
      mask->Voxels->Layers[static_cast<std::size_t>(mask->Structure.Layer)]->GetSpacing();
  return *std::max_element(spacing, spacing + 3);
}

int RungOfSubVoxel()
{
  return RungOf(StudyDial::SubVoxelLinear);
}
} // namespace

StudyTrade MeasureStudyTrade(const TradeSource& source, const TouchToolSettings& tool,
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
  std::vector<TradeCandidate> rungs;
  for (int rung = 0; rung < static_cast<int>(AllStudyRungs.size()); ++rung)
  {
    TradeSetting setting = SettingOf(rung, tool);
    setting.Degree = highest > 0 ? std::min(setting.Degree, highest) : setting.Degree;
    rungs.push_back({setting, TradeKnob::Representation});
  }
  StudyTrade trade;
  trade.Rungs = MeasureTrade(bench, rungs, progress);
  trade.VoxelMillimeters = LargestSpacing(source);
  return trade;
}

int ChosenRung(const StudyTrade& trade, double rate)
{
  int fastest = -1;
  int enough = -1;
  int truest = -1;
  const auto improves = [&](int& best, int rung, double TradeRow::*what)
  {
    const auto at = [&](int n) { return trade.Rungs[static_cast<std::size_t>(n)].*what; };
    best = best < 0 || at(rung) < at(best) ? rung : best;
  };
  for (int rung = 0; rung < static_cast<int>(trade.Rungs.size()); ++rung)
  {
    const TradeRow& row = trade.Rungs[static_cast<std::size_t>(rung)];
    if (!IsMeasured(row))
    {
      continue;
    }
    improves(fastest, rung, &TradeRow::TickMean);
    if (Fits(row, rate))
    {
      improves(truest, rung, &TradeRow::SurfaceMean);
    }
    if (Fits(row, rate) && IsTrueEnough(row, trade.VoxelMillimeters))
    {
      improves(enough, rung, &TradeRow::TickMean);
    }
  }
  return enough >= 0 ? enough : truest >= 0 ? truest : fastest;
}

const TradeRow* RowOf(const StudyTrade& trade, int rung)
{
  for (const int one : {rung, RungOfSubVoxel()})
  {
    const auto index = static_cast<std::size_t>(one);
    if (one >= 0 && index < trade.Rungs.size() && IsMeasured(trade.Rungs[index]))
    {
      return &trade.Rungs[index];
    }
  }
  return nullptr;
}

StudyFeel FeelOf(const StudyState& state, const StudyStructure& structure, const StudyTrade* trade)
{
  StudyFeel feel{structure.Representation, structure.Degree, state.Interpolation, -1};
  if (state.Dial == StudyDial::ByHand)
  {
    return feel;
  }
  feel.Rung = RungOf(state.Dial);
  if (state.Dial == StudyDial::Automatic)
  {
    const int chosen = trade != nullptr ? ChosenRung(*trade, state.Rate) : -1;
    feel.Rung = chosen >= 0 ? chosen : RungOf(StudyDial::Harmonics12);
  }
  const TradeSetting setting = trade != nullptr
                                   ? trade->Rungs[static_cast<std::size_t>(feel.Rung)].Setting
                                   : SettingOf(feel.Rung, state.Tool);
  const bool isField = setting.Representation == TouchRepresentation::SubVoxel;
  // Harmonics that are refused give way to the field.
  feel.Representation = isField ? TouchRepresentation::SubVoxel : TouchRepresentation::Automatic;
  feel.Degree = isField ? structure.Degree : setting.Degree;
  feel.Interpolation = isField ? setting.Interpolation : FieldInterpolation::Trilinear;
  return feel;
}

std::string Describe(const StudyFeel& feel)
{
  switch (feel.Representation)
  {
  case TouchRepresentation::Facets:
    return "facets";
  case TouchRepresentation::SubVoxel:
    return NameOf(feel.Interpolation == FieldInterpolation::Trilinear ? StudyDial::SubVoxelLinear
                                                                      : StudyDial::SubVoxelCubic);
  default:
    return "harmonics of degree " + std::to_string(feel.Degree);
  }
}
} // namespace palpate
