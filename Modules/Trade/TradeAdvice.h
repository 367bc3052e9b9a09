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
  bool IsMet = false;             ///< keeps the rate, and its errors are not known to be noticeable
  std::string Message;            ///< the recommendation and its reason
};

/// Of the settings whose 99.9 % tick reaches `servoRate` (Hz), those with errors (99 %) below one
/// just noticeable difference of force and 18 degrees of direction beyond the reference's
/// uncertainty, without seizures, count as equal, and so do those whose position error beyond it
/// exceeds the smallest one by less than half the uncertainty, which is one standard deviation. If
/// there are none, those do whose force error is within a tenth of the smallest, or whose position
/// error exceeds its by less than that. Of equal ones: those whose largest jump of the force,
/// beyond the reference's, is within one just noticeable difference of the least; of these those
/// that cost at most a quarter more than the cheapest; of these the one with the smallest force
/// error. If none reaches the rate, the one with the fastest mean tick.
PALPATETRADE_EXPORT TradeAdvice AdviseOn(const std::vector<TradeRow>& rows, double servoRate);
} // namespace palpate
