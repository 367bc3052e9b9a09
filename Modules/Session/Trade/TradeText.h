#pragma once

#include "PalpateSessionModule.h"
#include "TradeRun.h"

#include <string>

namespace palpate
{
/// All of a result as one JSON object: what was measured and how, and a structure's advice and
/// rows. Numbers that were not measured are null.
PALPATESESSION_EXPORT std::string TradeJson(const TradeResult& result);
} // namespace palpate
