#include "TradeCandidates.h"

#include <algorithm>

namespace palpate
{
namespace
{
constexpr int DefaultFacets = 8000;
constexpr int FinePoints = 98; // of a tool

void AddOnce(const TradeCandidate& candidate, std::vector<TradeCandidate>& candidates)
{
  if (std::none_of(candidates.begin(), candidates.end(),
                   [&candidate](const TradeCandidate& one)
                   { return one.Setting == candidate.Setting; }))
  {
    candidates.push_back(candidate);
  }
}

// The candidates of one representation: its default, and what differs from that by one knob.
class Variations
{
public:
  Variations(const TradeSetting& standard, std::vector<TradeCandidate>& candidates)
      : Standard(standard), Candidates(candidates)
  {
    this->Candidates.push_back({standard, TradeKnob::Representation});
  }

  template <typename Value>
  void Vary(TradeKnob knob, Value TradeSetting::*member, std::initializer_list<Value> values)
  {
    for (const Value value : values)
    {
      this->Add(knob, member, value);
    }
  }
  template <typename Value>
  void Add(TradeKnob knob, Value TradeSetting::*member, Value value)
  {
    TradeSetting setting = this->Standard;
    setting.*member = value;
    AddOnce({setting, knob}, this->Candidates);
  }

private:
  TradeSetting Standard;
  std::vector<TradeCandidate>& Candidates;
};

TradeSetting HarmonicsOf(const SceneStructure& asked, int highest)
{
  TradeSetting setting;
  setting.Representation = TouchRepresentation::Harmonics;
  setting.Degree = std::min(asked.Degree, highest);
  setting.Mode = asked.Mode;
  return setting;
}

void AddHarmonics(const TradeSetting& standard, int highest,
                  std::vector<TradeCandidate>& candidates)
{
  Variations variations(standard, candidates);
  for (const int degree : {4, 8, 12, 16, 24, 32})
  {
    if (degree <= highest)
    {
      variations.Add(TradeKnob::Degree, &TradeSetting::Degree, degree);
    }
  }
  variations.Vary(TradeKnob::Mode, &TradeSetting::Mode,
                  {HarmonicContactMode::Nearest, HarmonicContactMode::Radial});
  variations.Vary(TradeKnob::Drawing, &TradeSetting::DrawnFrequency, {5, 10, 20, 40});
}

// `count`: all that the surface has, 0 for one that is made of any number.
void AddFacets(int count, std::vector<TradeCandidate>& candidates)
{
  // One that is nearly whole would only be measured twice.
  const auto isFewer = [count](int facets) { return count == 0 || facets < 0.8 * count; };
  TradeSetting standard;
  standard.Representation = TouchRepresentation::Facets;
  standard.Facets = isFewer(DefaultFacets) ? DefaultFacets : 0;
  Variations variations(standard, candidates);
  for (const int facets : {500, 2000, 8000, 32000, 128000})
  {
    if (isFewer(facets))
    {
      variations.Add(TradeKnob::Facets, &TradeSetting::Facets, facets);
    }
  }
  if (count > 0)
  {
    variations.Add(TradeKnob::Facets, &TradeSetting::Facets, 0);
  }
}

void AddField(const SceneStructure& asked, const TouchToolSettings& tool,
              std::vector<TradeCandidate>& candidates)
{
  TradeSetting standard;
  standard.Representation = TouchRepresentation::SubVoxel;
  standard.Interpolation = asked.Interpolation;
  standard.ToolPoints = tool.Points;
  Variations variations(standard, candidates);
  variations.Vary(TradeKnob::Interpolation, &TradeSetting::Interpolation,
                  {FieldInterpolation::Trilinear, FieldInterpolation::TricubicBSpline});
  const bool isPoint = tool.Kind == TouchToolSettings::Shape::Sphere && tool.Radius == 0.0;
  if (!isPoint)
  {
    variations.Vary(TradeKnob::ToolPoints, &TradeSetting::ToolPoints, {6, 26, 98, 200});
    // The one place where two knobs are turned: a truer field tells only a finer tool apart.
    TradeSetting finest = standard;
    finest.Interpolation = FieldInterpolation::TricubicBSpline;
    finest.ToolPoints = FinePoints;
    AddOnce({finest, TradeKnob::ToolPoints}, candidates);
  }
}
} // namespace

std::vector<TradeCandidate> CandidatesOf(TradeModels& models, const SceneStructure& asked,
                                         const TouchToolSettings& tool,
                                         const ProgressFunction& progress)
{
  std::vector<TradeCandidate> candidates;
  const auto& is = models.Source().Is;
  const bool hasVoxels = std::holds_alternative<TradeSource::Mask>(is) ||
                         std::holds_alternative<TradeSource::Image>(is);
  const bool isModel = std::holds_alternative<TradeSource::Model>(is);
  // Harmonics and facets feel spheres only; an image's structure is seldom star-shaped.
  const bool isSphere = tool.Kind == TouchToolSettings::Shape::Sphere;
  if (isSphere && !std::holds_alternative<TradeSource::Image>(is))
  {
    const int highest = models.HighestDegree(progress);
    AddHarmonics(HarmonicsOf(asked, highest), highest, candidates);
  }
  if (isSphere)
  {
    AddFacets(isModel ? 0 : models.FacetCount(progress), candidates);
  }
  if (hasVoxels)
  {
    AddField(asked, tool, candidates);
  }
  return candidates;
}

std::vector<TradeCandidate> Only(std::vector<TradeCandidate> candidates,
                                 const std::set<TradeKnob>& knobs)
{
  if (!knobs.empty())
  {
    candidates.erase(std::remove_if(candidates.begin(), candidates.end(),
                                    [&](const TradeCandidate& candidate) {
                                      return candidate.Knob != TradeKnob::Representation &&
                                             knobs.count(candidate.Knob) == 0;
                                    }),
                     candidates.end());
  }
  return candidates;
}
} // namespace palpate
