#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

namespace palpate
{
/// A self-contained HTML page without scripts: for each structure the recommendation, plots of time
/// against error that mark the settings on the Pareto front, a table sorted by time, and a
/// description of the measurement.
PALPATETRADE_EXPORT std::string TradePage(const TradeResult& result);

/// Indices of the points (cost, error) on the Pareto front, sorted by cost: no other point is at
/// least as good in both and better in one. Points that are not finite are skipped.
PALPATETRADE_EXPORT std::vector<std::size_t>
ParetoFront(const std::vector<std::pair<double, double>>& points);
} // namespace palpate
