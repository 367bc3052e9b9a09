#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "StructureTrade.h"
#include "TradeAdvice.h"

#include <string>
#include <vector>

namespace palpate
{
/// What of a scene is measured, and how.
struct TradeRunSettings
{
  SceneSettings Scene;
  std::vector<std::string> Structures; ///< names; none for all
  StructureTrade::Settings Measurement;
  std::string Program; ///< name and version, for the results
};

/// One structure's rows and the recommendation that follows from them.
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
};

/// Measures the touchable structures of a scene, one after another. Throws InputError, FilterError
/// and Cancelled.
PALPATETRADE_EXPORT TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                                         const ProgressFunction& progress);
} // namespace palpate
