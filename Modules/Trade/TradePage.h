#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <string>

namespace palpate
{
/// A self-contained HTML page without scripts: for each structure the recommendation, plots of time
/// against error that mark the settings on the Pareto front, a table sorted by time, and a
/// description of the measurement.
PALPATETRADE_EXPORT std::string TradePage(const TradeResult& result);
} // namespace palpate
