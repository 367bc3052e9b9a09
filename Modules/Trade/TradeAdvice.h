#pragma once

#include "PalpateTradeModule.h"
#include "TradeRow.h"

#include <optional>
#include <string>
#include <vector>

namespace palpate
{
/// Recommendation among one structure's rows.
struct TradeAdvice
{
  std::optional<std::size_t> Row; ///< none if no setting was measured
  bool IsMet = false;             ///< keeps the rate, and its errors are not noticeable
  std::string Message;            ///< the recommendation and its reason
};

/// Of the settings whose 99.9 % tick reaches `servoRate` (Hz), the fastest, by its mean tick, whose
/// 99 % force error is below one just noticeable difference and 99 % direction error below 18
/// degrees, without seizures; if there is none, the fastest of those whose force error is within a
/// tenth of the smallest; if none reaches the rate, the fastest of all.
PALPATETRADE_EXPORT TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, double servoRate);
} // namespace palpate
