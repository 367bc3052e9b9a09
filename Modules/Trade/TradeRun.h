#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "TradeAdvice.h"
#include "TradeBench.h"
#include "TradeScene.h"
#include "TradeTable.h"

#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace palpate
{
/// What of a scene is measured, how, and where rows are kept.
struct TradeRunSettings
{
  SceneSettings Scene;
  std::set<TradeKnob> Knobs;           ///< none for all
  std::vector<std::string> Structures; ///< names; none for all
  TradePathSettings Path;
  int Runs = 5;
  std::optional<TradeNeeds> Needs;
  std::filesystem::path Table; ///< kept after every row, and gone on with; empty for none
  std::string Program;         ///< name and version: rows of others are measured again
};

/// One structure's rows and what to choose of them.
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
  std::size_t Kept = 0; ///< rows that an earlier run had measured
};

/// Measures what the table does not hold yet. The table is replaced whole after every row, so that
/// a run that is cancelled or killed loses the row at work. Rows that follow from another file,
/// tool, path, machine or program are measured again, and leave the table. Throws InputError,
/// FilterError and Cancelled.
PALPATETRADE_EXPORT TradeResult RunTrade(const TradeRunSettings& settings, const Clock& clock,
                                         const ProgressFunction& progress);
} // namespace palpate
