#pragma once

#include "PalpateTradeModule.h"
#include "TradeRun.h"

#include <string>

namespace palpate
{
/// One HTML page that needs nothing else and runs nothing: for each structure what to choose, plots
/// of time against error with the settings that no other beats, a table by rising time, and how all
/// was measured.
PALPATETRADE_EXPORT std::string TradePage(const TradeResult& result);
} // namespace palpate
