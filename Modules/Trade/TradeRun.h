#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "StructureTrade.h"
#include "TradeAdvice.h"

#include <string>
#include <vector>

namespace palpate
{
/// Settings of a measurement of a scene.
struct TradeRunSettings
{
  SceneSettings Scene;
  std::vector<std::string> Structures; ///< names; empty: all
  StructureTrade::Settings Measurement;
  std::string Program; ///< name and version, for the results
};

/// One structure's rows and the recommendation.
struct TradeStructureResult
{
  std::string Name;
  std::vector<TradeRow> Rows; ///< in the order of candidates
  TradeAdvice Advice;
};

struct TradeResult
{
  std::vector<TradeStructureResult> Structures;
  std::string Machine;
  TradeRunSettings Settings;
  /// The scene with one structure per label that is touched, measured ones with the setting that is
  /// advised. The tool has as many points as the most demanding of these needs.
  SceneSettings Advised;
};

/// Measures the touchable structures of a scene in turn. Throws InputError, FilterError and
/// Cancelled.
PALPATETRADE_EXPORT TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                                         const ProgressFunction& progress);
} // namespace palpate
