#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <string>
#include <vector>

namespace palpate
{
/// Why settings were not measured: a sentence for each reason, with how many it holds for.
PALPATETRADE_EXPORT std::vector<std::string> RefusalsOf(const TradeStructureResult& structure);

/// All of a result as one JSON object: what was measured and how, and a structure's advice and
/// rows. Numbers that were not measured are null.
PALPATETRADE_EXPORT std::string TradeJson(const TradeResult& result);
} // namespace palpate
