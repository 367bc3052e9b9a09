#pragma once

#include "PalpateTradeModule.h"
#include "TradePath.h"
#include "TradeRow.h"

#include <vector>

namespace palpate
{
/// Output of a setting in one tick.
struct FeltTick
{
  bool IsTouching = false;
  Vector3 Force = Vector3::Zero();      ///< N
  Vector3 ProxyWorld = Vector3::Zero(); ///< mm; only needed of a structure that yields
};

/// Fills in the errors of positions, forces and directions, those beyond the uncertainty, the
/// jumps, seizures and parted strokes of `row`, from ticks along `path` with only a spring of
/// `stiffness` (N/mm). A proxy that is off by the uncertainty u turns the force at depth d by up to
/// asin(u / d). Where the path has the force of a structure that yields, no positions: they are of
/// the shape at rest, which is not felt. NaN inputs give NaN.
PALPATETRADE_EXPORT void CompareWithTruth(const TradePath& path, const std::vector<FeltTick>& felt,
                                          double stiffness, TradeRow& row);

/// The quantile `part` (0 to 1): the smallest number that this part of them does not exceed. NaN if
/// there are none or any is NaN.
PALPATETRADE_EXPORT double QuantileOf(std::vector<double> numbers, double part);
PALPATETRADE_EXPORT double MeanOf(const std::vector<double>& numbers);
} // namespace palpate
