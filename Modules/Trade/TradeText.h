#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <string>
#include <vector>

namespace palpate
{
/// Reasons why settings were not measured: one message per reason, with the number of settings.
PALPATETRADE_EXPORT std::vector<std::string> RefusalsOf(const TradeStructureResult& structure);

/// A result as one JSON object: the settings of the measurement, and advice and rows of each
/// structure. Numbers that were not measured are null.
PALPATETRADE_EXPORT std::string TradeJson(const TradeResult& result);

/// A result as CSV, one line per structure and setting. Numbers that were not measured are empty.
PALPATETRADE_EXPORT std::string TradeCsv(const TradeResult& result);
} // namespace palpate
