#pragma once

#include "PalpateTradeModule.h"
#include "TradeModels.h"

#include <set>
#include <vector>

namespace palpate
{
/// A setting that is worth measuring, and the knob by which it differs from its representation's
/// default.
struct TradeCandidate
{
  TradeSetting Setting;
  TradeKnob Knob = TradeKnob::Representation;
};

/// A default for each representation that the source and the tool allow, as `asked` has it, each
/// followed by variations of one knob at a time (and a field's finest).
PALPATETRADE_EXPORT std::vector<TradeCandidate> CandidatesOf(TradeModels& models,
                                                             const SceneStructure& asked,
                                                             const TouchToolSettings& tool,
                                                             const ProgressFunction& progress);

/// Only the variations of some knobs, and the defaults; all where there is none.
PALPATETRADE_EXPORT std::vector<TradeCandidate> Only(std::vector<TradeCandidate> candidates,
                                                     const std::set<TradeKnob>& knobs);
} // namespace palpate
