#pragma once

#include "PalpateTradeModule.h"
#include "TradeRow.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// What to choose of one structure's rows.
struct TradeAdvice
{
  std::optional<std::size_t> Row; ///< none where no setting was measured
  bool IsMet = false;             ///< reaches the rate with errors that are not noticed
  std::string Sentence;           ///< what to choose, and why
};

/// Of the settings whose 99.9 % tick reaches `servoRate` (Hz), the fastest, by its mean tick, whose
/// 99 % force error is below one just noticeable difference and 99 % direction error below 18
/// degrees, without seizures; if there is none, the fastest of those within a tenth of the least
/// force error; if none reaches the rate, the fastest of all.
PALPATETRADE_EXPORT TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, double servoRate);
} // namespace palpate
