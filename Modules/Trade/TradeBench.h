#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "TradeCandidates.h"
#include "TradePath.h"
#include "TradeRow.h"

#include <memory>
#include <vector>

namespace palpate
{
/// Measures one structure: by each setting its time a tick, its errors against one reference on one
/// seeded path, what it takes to make. From sources in memory; knows no files. Used by one thread.
class PALPATETRADE_EXPORT TradeBench
{
public:
  /// How each setting is felt; what `asked` says of representations is where candidates begin.
  struct Settings
  {
    SceneStructure Asked;
    TouchToolSettings Tool;
    TradePathSettings Path;
    int Runs = 5; ///< a tick's time is the least of so many
  };

  /// Keeps the address of the clock.
  TradeBench(TradeSource source, Settings settings, const Clock& clock);
  ~TradeBench();

  /// What is worth measuring here. Throws InputError, FilterError and Cancelled, as Measure does.
  std::vector<TradeCandidate> Candidates(const ProgressFunction& progress);

  /// One setting. The first call makes the reference and the path. A setting that cannot be made of
  /// this structure gives a row that says so; throws InputError where there is no reference, which
  /// is where the tool cannot touch the structure at all, and Cancelled.
  TradeRow Measure(const TradeCandidate& candidate, const ProgressFunction& progress);

  /// The path with its truths, as Measure uses it.
  const TradePath& Path(const ProgressFunction& progress);

private:
  void Prepare(const ProgressFunction& progress);
  void Fill(const TradeSetting& setting, TradeRow& row, const ProgressFunction& progress);

  TradeModels Models;
  Settings Asked;
  const Clock& Time;
  std::unique_ptr<TradeReference> Reference;
  TradePath Way;
};

/// All candidates, in their order.
PALPATETRADE_EXPORT std::vector<TradeRow>
MeasureTrade(TradeBench& bench, const std::vector<TradeCandidate>& candidates,
             const ProgressFunction& progress);
} // namespace palpate
