#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <string>
#include <vector>

namespace palpate
{
/// Why settings were not measured: a message for each reason, with the number of settings.
PALPATETRADE_EXPORT std::vector<std::string> RefusalsOf(const TradeStructureResult& structure);

/// All of a result as one JSON object: what was measured and how, and a structure's advice and
/// rows. Numbers that were not measured are null.
PALPATETRADE_EXPORT std::string TradeJson(const TradeResult& result);

/// A line for each setting of a structure. Numbers that were not measured are empty.
PALPATETRADE_EXPORT std::string TradeCsv(const TradeResult& result);
} // namespace palpate
