#pragma once

#include "Clock.h"
#include "PalpateTradeModule.h"
#include "TradePath.h"
#include "TradeRow.h"

namespace palpate
{
/// How a model is felt while it is measured.
struct TradeTouch
{
  TouchToolSettings Tool;
  double Stiffness = 0.5; ///< N/mm
  int Runs = 5;           ///< a tick's time is the least of so many runs of the same way
};

/// Follows `path` as a servo does and fills in what `row` says of ticks, positions, forces,
/// directions and jumps. Without friction and damping, so that only the representation differs.
/// Ticks whose truth nobody knows, and those where neither touches, count in the times alone.
/// Throws InputError where the tool cannot touch the model, and Cancelled.
PALPATETRADE_EXPORT void MeasureTouch(const ContactModel& model, const TradeTouch& touch,
                                      const TradePath& path, const Clock& clock, TradeRow& row,
                                      const ProgressFunction& progress);
} // namespace palpate
