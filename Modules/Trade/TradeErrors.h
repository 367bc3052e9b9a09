#pragma once

#include "PalpateTradeModule.h"
#include "TradePath.h"
#include "TradeRow.h"

#include <vector>

namespace palpate
{
/// What a setting let be felt in one tick.
struct FeltTick
{
  bool IsTouching = false;
  Vector3 Force = Vector3::Zero(); ///< N
};

/// Fills in what `row` says of positions, forces, directions, jumps and seizures, of ticks that
/// were felt along `path` with a spring of `stiffness` (N/mm) alone. What is no number stays none.
PALPATETRADE_EXPORT void CompareWithTruth(const TradePath& path, const std::vector<FeltTick>& felt,
                                          double stiffness, TradeRow& row);

/// The least number that this part (0 to 1) of them does not exceed; NaN of none, and where one is
/// NaN.
PALPATETRADE_EXPORT double QuantileOf(std::vector<double> numbers, double part);
PALPATETRADE_EXPORT double MeanOf(const std::vector<double>& numbers);
} // namespace palpate
